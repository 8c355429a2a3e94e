#include "tasks/task_contract.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tasks/adapt_contract.h"
#include "tasks/assemble_contract.h"
#include "tasks/assimilate_contract.h"
#include "tasks/collect_contract.h"
#include "tasks/cosmetic_contract.h"
#include "tasks/decompose_contract.h"
#include "tasks/extract_contract.h"
#include "tasks/grow_contract.h"
#include "tasks/inspect_contract.h"
#include "tasks/mesh_contract.h"
#include "tasks/number_contract.h"
#include "tasks/order_contract.h"
#include "tasks/remesh_contract.h"
#include "tasks/solve_contract.h"
#include "tasks/task_contracts.h"
#include "tasks/write_contract.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// One side of a kind with all that it may have, and what of that may be missing.
struct Side {
  std::string name;
  TaskWords words;
  std::set<std::string> optional;
  std::function<TaskWords(const TaskWords&)> there_and_back;
  bool is_given = false;
};

template <class Contract>
Side side_of(const std::string& name, const Contract& full,
             const std::set<std::string>& optional = {}) {
  return {name, to_words(full), optional,
          [](const TaskWords& words) {
            const ContractReading<Contract> reading = from_words<Contract>(words);
            if (!reading.breach.empty()) throw std::invalid_argument(reading.breach);
            return to_words(reading.contract);
          },
          Contract::side == ContractSide::given};
}

TaskFile file(const std::string& hash) { return {hash, hash.size()}; }

std::vector<Side> all_sides() {
  const LeafFiles two = {{4, file("four")}, {(std::uint64_t{1} << 63U) - 1, file("deepest")}};
  const DecomposeMade::Half half = {file("h"), 0.5, 3, 7};
  const std::set<std::string> leaves = {"core:4", "core:9223372036854775807", "elements:4",
                                        "elements:9223372036854775807"};
  std::set<std::string> of_write = leaves;
  of_write.insert({"colours", "top_heights"});
  std::set<std::string> of_number = leaves;
  of_number.insert({"layer_table", "dropped", "order"});
  const auto each = [](const std::string& prefix) {
    return std::set<std::string>{prefix + "4", prefix + "9223372036854775807"};
  };
  std::set<std::string> turns = each("waits:");
  turns.merge(each("had_turn:"));
  std::set<std::string> portions = each("portion:");
  portions.merge(each("tets:"));
  portions.insert("layer_map");
  std::set<std::string> of_solver = each("file:");
  of_solver.merge(each("spline:"));
  of_solver.insert({"start", "file_names"});
  std::set<std::string> of_cycles;
  for (const char* prefix : {"mesh:", "solution:", "log:", "figures:", "kept:"}) {
    of_cycles.merge(each(prefix));
  }
  std::set<std::string> of_layers = each("layers:");
  of_layers.insert({"layer_table", "layer_map", "top_heights"});
  return {
      side_of("remesh given", RemeshGiven{file("j"), file("i")}),
      side_of("remesh made", RemeshMade{file("s")}),
      side_of("inspect given", InspectGiven{file("j"), file("i"), 5, file("r")},
              {"input_surface", "free_bytes", "remeshed_surface"}),
      side_of("inspect made",
              InspectMade{file("s"), file("p"), file("r"), file("t"), 12, 1e6 / 3, 2, 1U << 30U, 9,
                          true, two, file("l"), file("m"), file("h")},
              of_layers),
      side_of("decompose given", DecomposeGiven{file("j"), file("s"), file("p"), 3, 4, 1000, 5, 6},
              {"most_bytes", "needles"}),
      side_of("decompose made", DecomposeMade{DecomposeMade::Halves{half, half, 17}, "a reason"},
              {"left_parts", "right_parts", "reason"}),
      side_of("assimilate given", AssimilateGiven{file("j"), two, "4 10\n"}, each("subdomain:")),
      side_of("assimilate made", AssimilateMade{two, file("d"), "4 4\n"}, each("group:")),
      side_of("mesh given", MeshGiven{file("j"), file("s"), file("p"), 1000, 3}, {"needles"}),
      side_of("mesh made", MeshMade{file("m"), 10, 100}),
      side_of("order given", OrderGiven{two}, each("subdomain:")),
      side_of("order made", OrderMade{two, "4 0\n"}, each("shared:")),
      side_of("extract given", ExtractGiven{file("s"), file("m"), file("h")}),
      side_of("extract made", ExtractMade{file("e")}),
      side_of("cosmetic given", CosmeticGiven{file("p"), file("o"), two, two, "4 0\n"}, turns),
      side_of("cosmetic made", CosmeticMade{file("e")}),
      side_of("number given",
              NumberGiven{file("s"), file("l"), file("d"), two, two, "cut 1 5\n", "4 0\n"},
              of_number),
      side_of("number made", NumberMade{file("n")}),
      side_of("write given",
              WriteGiven{file("j"),
                         file("s"),
                         file("n"),
                         file("d"),
                         file("m"),
                         {{4, file("four")}},
                         two,
                         "4 0\n",
                         file("h")},
              of_write),
      side_of("write made", WriteMade{file("p"), file("t")}),
      side_of("grow given", GrowGiven{file("j"), file("s"), file("n"), file("l")}),
      side_of("grow made", GrowMade{file("p"), file("c")}),
      side_of("assemble given", AssembleGiven{file("j"), file("s"), file("n"), two, two, file("m")},
              portions),
      side_of("solve given", SolveGiven{file("j"), file("m"), file("s"), file("n"), two, two, 3, 6},
              of_solver),
      side_of("solve made", SolveMade{file("s"), file("l"), two}, each("kept:")),
      side_of("adapt given", AdaptGiven{file("j"), file("m"), file("s"), two, 3}, each("spline:")),
      side_of("adapt made", AdaptMade{file("m"), file("s"), file("f")}),
      side_of("collect given", CollectGiven{file("j"), two, two, two, two, two}, of_cycles),
  };
}

/// The words without one of them, each with its name.
std::vector<std::pair<std::string, TaskWords>> each_left_out(const TaskWords& words) {
  std::vector<std::pair<std::string, TaskWords>> all;
  for (std::size_t i = 0; i < words.files.size(); ++i) {
    all.emplace_back(words.files[i].first, words);
    auto& files = all.back().second.files;
    files.erase(files.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (const auto& [name, text] : words.texts) {
    all.emplace_back(name, words);
    all.back().second.texts.erase(name);
  }
  for (const auto& [name, number] : words.numbers) {
    all.emplace_back(name, words);
    all.back().second.numbers.erase(name);
  }
  return all;
}

std::string breach_of(const Side& side, const TaskWords& words) {
  try {
    side.there_and_back(words);
  } catch (const std::invalid_argument& breach) {
    return breach.what();
  }
  return {};
}

TEST(TaskContracts, say_the_same_after_they_have_travelled) {
  for (const Side& side : all_sides()) {
    EXPECT_EQ(side.there_and_back(side.words), side.words) << side.name;
  }
}

TEST(TaskContracts, refuse_each_field_that_is_missing_and_name_it) {
  for (const Side& side : all_sides()) {
    for (const auto& [name, words] : each_left_out(side.words)) {
      if (side.optional.contains(name)) {
        EXPECT_EQ(side.there_and_back(words), words) << side.name << " without " << name;
      } else if (side.name != "decompose made" || name != "left") {
        EXPECT_THAT(breach_of(side, words), HasSubstr("'" + name + "' is missing")) << side.name;
      }
    }
  }
}

TEST(TaskContracts, refuse_what_a_task_is_given_and_nobody_asked_for_but_not_what_it_says_besides) {
  for (const Side& side : all_sides()) {
    TaskWords words = side.words;
    words.files.emplace_back("spare", file("x"));
    words.texts["spare"] = "1";
    words.numbers["spare"] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(breach_of(side, words).empty(), !side.is_given) << side.name;
    TaskWords file_alone = side.words;
    file_alone.files.emplace_back("spare", file("x"));
    EXPECT_EQ(breach_of(side, file_alone).empty(), !side.is_given) << side.name;
    TaskWords text_alone = side.words;
    text_alone.texts["spare"] = "1";
    EXPECT_EQ(breach_of(side, text_alone).empty(), !side.is_given) << side.name;
  }
}

TEST(TaskContracts, refuse_numbers_that_are_none_or_out_of_their_bounds) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Side& side : all_sides()) {
    for (const auto& [name, number] : side.words.numbers) {
      for (const double hostile : {-1.0, inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
        TaskWords words = side.words;
        words.numbers[name] = hostile;
        EXPECT_THAT(breach_of(side, words), HasSubstr("'" + name + "' cannot be")) << side.name;
      }
    }
  }
  MeshGiven mesh;
  for (const std::string hostile : {"", " 1", "1 ", "x", "-1", "1e300", "0x10", "1.5", "nan", "inf",
                                    "99999999999999999999", "1\n"}) {
    TaskWords words = to_words(mesh);
    words.texts["work"] = hostile;
    EXPECT_NE(from_words<MeshGiven>(words).breach, "") << hostile;
  }
  TaskWords parts = to_words(DecomposeGiven{});
  parts.texts["left_parts"] = "1000001";
  EXPECT_NE(from_words<DecomposeGiven>(parts).breach, "");
  for (const char* name : {"parts", "groups"}) {
    TaskWords inspected = to_words(InspectMade{});
    inspected.numbers[name] = 1'000'001;
    EXPECT_NE(from_words<InspectMade>(inspected).breach, "") << name;
  }
}

TEST(TaskContracts, refuse_files_of_no_sub_domain_and_two_of_one_name) {
  for (const std::string name :
       {"subdomain:", "subdomain:0", "subdomain:x", "subdomain:4x", "subdomain:-4", "subdomain: 4",
        "subdomain:04", "subdomain:9223372036854775808", "subdomain:4/../.."}) {
    const TaskWords words = {{{name, file("a")}}, {}, {}};
    EXPECT_NE(from_words<OrderGiven>(words).breach, "") << name;
  }
  const TaskWords twice = {{{"subdomain:4", file("a")}, {"subdomain:4", file("b")}}, {}, {}};
  EXPECT_NE(from_words<OrderGiven>(twice).breach, "");
}

TEST(TaskContracts, of_a_sub_domain_that_stays_whole_ask_for_nothing) {
  const TaskWords whole = {{}, {{"reason", "no valid plane"}}, {}};
  const auto made = from_words<DecomposeMade>(whole).contract;
  EXPECT_FALSE(made.halves);
  EXPECT_EQ(made.reason, "no valid plane");
  EXPECT_EQ(from_words<DecomposeMade>({}).breach, "");
}

/// The table names what every result has; the contract says what else there may be.
TEST(TaskContracts, ask_for_the_outputs_that_the_table_names) {
  for (const TaskKind kind : all_task_kinds) {
    for (const std::string_view output : traits_of(kind).outputs) {
      if (output.empty() || output.ends_with(':') || traits_of(kind).may_make_nothing) continue;
      EXPECT_THAT(breach_of_made(kind, {}), HasSubstr("is missing")) << output;
    }
  }
}

std::vector<std::string> names_in(const TaskWords& words) {
  std::vector<std::string> names;
  for (const auto& [name, file] : words.files) names.push_back(name);
  return names;
}

/// Rows of older versions have these orders, and a task that is run again has to make the same.
TEST(TaskContracts, name_files_of_leaves_leaf_by_leaf_in_the_order_that_they_always_had) {
  const LeafFiles three = {{4, file("a")}, {5, file("b")}, {6, file("c")}};
  EXPECT_THAT(names_in(to_words(NumberGiven{file("s"), {}, {}, three, three, "", {}})),
              ElementsAre("surface", "core:4", "elements:4", "core:5", "elements:5", "core:6",
                          "elements:6"));
  EXPECT_THAT(names_in(to_words(CosmeticGiven{
                  file("p"), file("o"), {{6, file("c")}}, {{4, file("a")}, {7, file("d")}}, ""})),
              ElementsAre("spacing", "own", "had_turn:4", "waits:6", "had_turn:7"));
  EXPECT_THAT(
      names_in(to_words(WriteGiven{
          file("j"), file("s"), file("n"), file("d"), file("m"), {{5, file("b")}}, three, {}, {}})),
      ElementsAre("job", "surface", "numbering", "subdomain", "mesh", "core:5", "elements:5",
                  "elements:4", "elements:6"))
      << "the leaf itself first";
  EXPECT_THAT(names_in(to_words(AssimilateMade{
                  {{3, file("r")}, {4, file("ll")}, {10, file("lrl")}}, file("d"), ""})),
              ElementsAre("group:4", "group:10", "group:3", "dropped"))
      << "as they come in the tree";
}

TEST(TaskContracts, tell_the_name_under_which_a_field_travels) {
  EXPECT_STREQ(field_name(&MeshGiven::work), "work");
  EXPECT_STREQ(field_name(&InspectGiven::free_bytes), "free_bytes");
  EXPECT_STREQ(field_name(&WriteGiven::elements), "elements:");
  EXPECT_STREQ(field_name(&InspectMade::across_cuts), "across_cuts");
  EXPECT_DEATH(field_name(&DecomposeMade::halves), "");
}

TEST(TaskContracts, take_whole_numbers_up_to_their_bound_and_nothing_else) {
  EXPECT_EQ(whole_count(std::string("9007199254740992")), most_of_a_count);
  EXPECT_EQ(whole_count(std::string("9007199254740993")), std::nullopt);
  EXPECT_EQ(whole_count(9007199254740992.0), most_of_a_count);
  EXPECT_EQ(whole_count(9007199254740994.0), std::nullopt);
  EXPECT_EQ(whole_count(7.0, 7), 7U);
  EXPECT_EQ(whole_count(8.0, 7), std::nullopt);
  EXPECT_EQ(whole_count(0.5), std::nullopt);
  EXPECT_EQ(whole_count(-1.0), std::nullopt);
}

/// The words of each side by name, as they lie in databases and travel between versions.
TEST(TaskContracts, have_the_names_that_they_always_had) {
  const std::map<std::string, std::string> names = {
      {"remesh given", "job input_surface | |"},
      {"remesh made", "surface | |"},
      {"inspect given", "job input_surface remeshed_surface | free_bytes |"},
      {"inspect made",
       "surface spacing root settings layers: layer_table layer_map top_heights | | across_cuts "
       "groups most_bytes needles parts total_work"},
      {"decompose given",
       "job subdomain spacing | left_parts most_bytes needles right_parts work |"},
      {"decompose made",
       "left right | reason | interdomain_nodes left_needles left_parts left_work right_needles "
       "right_parts right_work"},
      {"assimilate given", "job subdomain: | table |"},
      {"assimilate made", "group: dropped | groups |"},
      {"mesh given", "job subdomain spacing | needles work |"},
      {"mesh made", "mesh | | interior_nodes tets"},
      {"order given", "subdomain: | |"},
      {"order made", "shared: | order |"},
      {"extract given", "subdomain mesh shared | |"},
      {"extract made", "elements | |"},
      {"cosmetic given", "spacing own waits: had_turn: | colours |"},
      {"cosmetic made", "elements | |"},
      {"number given", "surface layer_table dropped core: elements: | order table |"},
      {"number made", "numbering | |"},
      {"write given",
       "job surface numbering subdomain mesh core: elements: top_heights | colours |"},
      {"write made", "portion tets | |"},
      {"grow given", "job surface numbering layers | |"},
      {"grow made", "portion cells | |"},
      {"assemble given", "job surface numbering portion: tets: layer_map | |"},
      {"solve given", "job mesh start file_names file: spline: | cycle cycles |"},
      {"solve made", "solution log kept: | |"},
      {"adapt given", "job mesh solution spline: | cycle |"},
      {"adapt made", "mesh start figures | |"},
      {"collect given", "job mesh: solution: log: figures: kept: | |"}};
  for (const Side& side : all_sides()) {
    std::string text;
    std::set<std::string> seen;
    for (const auto& [name, file] : side.words.files) {
      const std::string field =
          name.substr(0, name.find(':') == name.npos ? name.size() : name.find(':') + 1);
      if (seen.insert(field).second) text += field + " ";
    }
    text += "|";
    for (const auto& [name, value] : side.words.texts) text += " " + name;
    text += " |";
    for (const auto& [name, value] : side.words.numbers) text += " " + name;
    EXPECT_EQ(text, names.at(side.name));
  }
}

TEST(TaskContracts, say_in_full_what_is_wrong) {
  const auto given = [](const TaskWords& words) {
    return from_words<DecomposeGiven>(words).breach;
  };
  const TaskWords good =
      to_words(DecomposeGiven{file("j"), file("s"), file("p"), 3, 4, 1000, {}, {}});
  EXPECT_EQ(given(good), "");
  const auto with_text = [&good](const char* name, const char* text) {
    TaskWords words = good;
    words.texts[name] = text;
    return words;
  };
  EXPECT_EQ(given({}), "the file 'job' is missing") << "the first that is wrong is told";
  EXPECT_EQ(given(with_text("left_parts", "1000001")),
            "the number 'left_parts' cannot be '1000001'");
  EXPECT_EQ(given(with_text("left_parts", "1000000")), "");
  EXPECT_EQ(given(with_text("right_parts", "1000001")),
            "the number 'right_parts' cannot be '1000001'");
  EXPECT_EQ(given(with_text("work", "-1")), "the number 'work' cannot be '-1'");
  EXPECT_EQ(given(with_text("work", "9007199254740993")),
            "the number 'work' cannot be '9007199254740993'");
  EXPECT_EQ(given(with_text("needles", "x")), "the number 'needles' cannot be 'x'");
  EXPECT_EQ(given(with_text("spare", "x")), "the parameter 'spare' is unknown");
  TaskWords twice = good;
  twice.files.push_back(twice.files[0]);
  EXPECT_EQ(given(twice), "the file 'job' is there twice");
  TaskWords spare = good;
  spare.files.emplace_back("spare", file("x"));
  EXPECT_EQ(given(spare), "the file 'spare' is unknown");
  TaskWords lacks = good;
  lacks.texts.erase("work");
  EXPECT_EQ(given(lacks), "the number 'work' is missing");
  EXPECT_EQ(from_words<OrderGiven>({{{"subdomain:04", file("a")}}, {}, {}}).breach,
            "the file 'subdomain:04' is of no sub-domain");
  EXPECT_EQ(from_words<OrderMade>({}).breach, "the text 'order' is missing");
  TaskWords made = to_words(InspectMade{});
  made.numbers["total_work"] = -0.5;
  EXPECT_EQ(from_words<InspectMade>(made).breach, "the number 'total_work' cannot be -0.500000");
  made = to_words(InspectMade{});
  made.numbers["across_cuts"] = 2;
  EXPECT_EQ(from_words<InspectMade>(made).breach, "the number 'across_cuts' cannot be 2.000000");
  made.numbers["across_cuts"] = 1;
  EXPECT_TRUE(from_words<InspectMade>(made).contract.across_cuts);
  made.numbers["across_cuts"] = 0;
  EXPECT_FALSE(from_words<InspectMade>(made).contract.across_cuts);
}

TEST(TaskContracts, have_a_bound_for_each_number) {
  const auto breach = [](const auto& contract, const char* name, double value) {
    TaskWords words = to_words(contract);
    words.numbers[name] = value;
    return from_words<std::decay_t<decltype(contract)>>(words).breach;
  };
  for (const char* name : {"parts", "groups"}) {
    EXPECT_EQ(breach(InspectMade{}, name, 1e6), "") << name;
    EXPECT_NE(breach(InspectMade{}, name, 1e6 + 1), "") << name;
    EXPECT_NE(breach(InspectMade{}, name, 0.5), "") << name;
  }
  for (const char* name : {"most_bytes", "needles"}) {
    EXPECT_EQ(breach(InspectMade{}, name, 0x1p53), "") << name;
    EXPECT_NE(breach(InspectMade{}, name, 0x1p54), "") << name;
  }
  const DecomposeMade::Half half = {file("h"), 1, 2, 3};
  const DecomposeMade halves{DecomposeMade::Halves{half, half, 1}, {}};
  for (const char* name : {"left_parts", "right_parts"}) {
    EXPECT_EQ(breach(halves, name, 1e6), "") << name;
    EXPECT_NE(breach(halves, name, 1e6 + 1), "") << name;
  }
  for (const char* name : {"interdomain_nodes", "left_needles", "right_needles"}) {
    EXPECT_EQ(breach(halves, name, 1e15), "") << name;
    EXPECT_NE(breach(halves, name, 1.5), "") << name;
  }
  for (const char* name : {"left_work", "right_work"}) {
    EXPECT_EQ(breach(halves, name, 1.5), "") << name;
    EXPECT_NE(breach(halves, name, -1.5), "") << name;
  }
}

TEST(TaskContracts, are_found_by_the_kind) {
  for (const TaskKind kind : all_task_kinds) {
    TaskWords spare;
    spare.files.emplace_back("spare", file("x"));
    EXPECT_NE(breach_of_given(kind, spare), "") << name_of(kind);
    const bool needs_nothing = kind == TaskKind::decompose || traits_of(kind).ends_job;
    EXPECT_EQ(breach_of_made(kind, {}).empty(), needs_nothing) << name_of(kind);
  }
  EXPECT_EQ(breach_of_given(TaskKind::cosmetic, {}), "the file 'spacing' is missing");
  EXPECT_EQ(breach_of_made(TaskKind::write, {}), "the file 'portion' is missing");
}

}  // namespace
}  // namespace tetfarm
