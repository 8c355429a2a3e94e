#include "tasks/order_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits order_traits = {
    .name = "order",
    .on_wire = 7,
    .rank = 0,
    .colour = "#999999",
    .trace_colour = "grey",
    .outputs = {"shared:"},
    .seconds = {.of = {0.006, 0, 0.3e-6, 0}},
    .memory = {.of_triangle = 32, .of_triangle_of_largest = 200},
    .needs_whole_tree = true,
    .reads_file_by_file = true,
};

constinit const KindContracts order_contracts = contracts_between<OrderGiven, OrderMade>;

void OrderGiven::describe(ContractFields& fields) { fields.files("subdomain:", subdomains); }

void OrderMade::describe(ContractFields& fields) {
  fields.files("shared:", shared);
  fields.text("order", order);
}

}  // namespace tetfarm
