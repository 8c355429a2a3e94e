# While it is installed: has `program` print its manual and its completion of shells, and puts them where man and the
# shells look. `made` is a folder for them, `manual` and `data` are where such files go below the prefix.
function(ask_program)
  execute_process(COMMAND ${program} ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(install_completion shell folder name)
  ask_program(completion ${shell} OUTPUT_FILE ${made}/${name})
  file(INSTALL ${made}/${name} DESTINATION ${data}/${folder})
endfunction()

foreach(folder manual data)
  cmake_path(ABSOLUTE_PATH ${folder} BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
endforeach()
file(REMOVE_RECURSE ${made})
file(MAKE_DIRECTORY ${made}/man)
ask_program(man --output ${made}/man)
file(INSTALL ${made}/man/ DESTINATION ${manual})
install_completion(bash bash-completion/completions tetfarm)
# Debian's zsh has a folder for packages, and looks nowhere else below /usr.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  install_completion(zsh zsh/vendor-completions _tetfarm)
else()
  install_completion(zsh zsh/site-functions _tetfarm)
endif()
install_completion(fish fish/vendor_completions.d tetfarm.fish)
