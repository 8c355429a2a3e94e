# While it is installed: has tetfarm_program print its manual and its completion for shells, and puts them where man and
# the shells look. tetfarm_made is a folder for them; tetfarm_manual and tetfarm_data are where such files go below the
# prefix.
function(ask_program)
  execute_process(COMMAND ${tetfarm_program} ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(install_completion shell folder name)
  ask_program(completion ${shell} OUTPUT_FILE ${tetfarm_made}/${name})
  file(INSTALL ${tetfarm_made}/${name} DESTINATION ${tetfarm_data}/${folder})
endfunction()

foreach(folder tetfarm_manual tetfarm_data)
  cmake_path(ABSOLUTE_PATH ${folder} BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
endforeach()
file(REMOVE_RECURSE ${tetfarm_made})
file(MAKE_DIRECTORY ${tetfarm_made}/man)
ask_program(man --output ${tetfarm_made}/man)
file(INSTALL ${tetfarm_made}/man/ DESTINATION ${tetfarm_manual})
install_completion(bash bash-completion/completions tetfarm)
# Debian's zsh has a folder for packages, and looks nowhere else below /usr.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  install_completion(zsh zsh/vendor-completions _tetfarm)
else()
  install_completion(zsh zsh/site-functions _tetfarm)
endif()
install_completion(fish fish/vendor_completions.d tetfarm.fish)
