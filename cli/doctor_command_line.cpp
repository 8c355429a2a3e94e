#include "cli/doctor_command_line.h"

#include "cli/client_options.h"

namespace tetfarm {

void add_doctor(CLI::App& sub, DoctorCommand& doctor) {
  CLI::Option* store =
      sub.add_option("--store", doctor.store, "Store of a coordinator, or output folder of a run")
          ->envname("TETFARM_STORE")
          ->option_text("DIR");
  sub.add_option("--database", doctor.database, "Folder of the database (default: the store)")
      ->option_text("DIR");
  sub.add_option("--folder", doctor.folder,
                 "Instead of a store, the folder that `run` is to work in (default: this one)")
      ->excludes(store)
      ->option_text("DIR");
  sub.add_option("--listen", doctor.endpoints,
                 "Address that a coordinator is to listen on; may be repeated")
      ->option_text("tcp://ADDRESS:PORT");
  sub.add_option("--keys", doctor.keys,
                 "Folder of the coordinator's keys (default: as `coordinator` looks for it)")
      ->envname("TETFARM_KEYS")
      ->option_text("DIR");
  sub.add_option("--memory", doctor.memory_bytes, "Memory that a worker here is to be told of")
      ->transform(CLI::AsSizeValue(false))
      ->option_text("SIZE");
  sub.add_option("--pool", doctor.pool, "Batch system that has to be there (default: any, or none)")
      ->check(CLI::IsMember({"slurm", "condor", "lsf", "ge"}))
      ->option_text("slurm|condor|lsf|ge");
  add_connection(sub, doctor.client, StoreOption::yes);
}

}  // namespace tetfarm
