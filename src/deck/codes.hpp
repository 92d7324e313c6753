// The codes of deck errors: stable, so that scripts and tests may rely on them. `print_reference` prints this table.
#pragma once

#include <array>
#include <string_view>

namespace mortise {

struct DeckCode {
  std::string_view code;
  std::string_view meaning;
};

inline constexpr std::array<DeckCode, 23> deck_codes{{
    {"D01", "the file is not well-formed XML text (syntax, empty, NUL bytes, not UTF-8, DOCTYPE)"},
    {"D02", "unknown XML element, or text between elements"},
    {"D03", "unknown, repeated or missing XML attribute, or unknown value of `type`"},
    {"D04", "the file is larger than 16 MB, or lists are nested deeper than 32"},
    {"D05", "a name or entry is repeated"},
    {"D06", "unknown parameter or list"},
    {"D07", "a required parameter or list is missing"},
    {"D08", "a value is out of its bounds"},
    {"D09", "a value has the wrong type, is not a number, or is not representable"},
    {"D10", "a value is not one of the names to choose from"},
    {"D11", "a name of the user is not allowed (empty, comma, dot, slash, quote, blank at an end)"},
    {"D12", "exactly one, or at least one, of several parameters must be set"},
    {"D13", "a parameter is set but unused, because of another choice"},
    {"D14", "a value refers to a mesh, material, pair, support or probe that the deck does not have"},
    {"D15", "a mesh, material or table is not used by anything"},
    {"D16", "a formula cannot be compiled"},
    {"D17", "a sequence is not ascending, or lengths differ"},
    {"D18", "a list is declared but empty"},
    {"D19", "two statements contradict each other"},
    {"D20", "a block, side set, node set or node is not in the mesh (found when the meshes are read)"},
    {"D21", "prescribed motions contradict each other (found when the meshes are read, or at the first step where they do)"},
    {"D22", "the bodies are not held: a rigid mode is free in statics (found when the meshes are read)"},
    {"D23",
     "a formula gives no finite value, or friction a negative one (found at the first step where it does not; the steps before "
     "are kept)"},
}};

}  // namespace mortise
