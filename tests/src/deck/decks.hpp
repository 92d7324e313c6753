// Decks for the tests of this room: the complete deck of the conventions, changes to it, and what reading gives.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "deck/deck.hpp"
#include "errors.hpp"

namespace mortise::test {

/// The deck of the conventions, section 4, letter by letter.
inline const std::string ironing_deck = R"deck(<ParameterList name="ironing frictionless">
  <Parameter name="title" type="string" value="Thesis 6.3.1: ironing, frictionless, depth 0.7"/>

  <ParameterList name="meshes">                      <!-- each: `file` (path) or `recipe`; placed by `origin` and `rotation` = {axis x, y, z, degrees} about it -->
    <ParameterList name="slab">
      <Parameter name="recipe"   type="string"        value="block"/>
      <Parameter name="size"     type="Array(double)" value="{9, 4, 3}"/>
      <Parameter name="elements" type="Array(int)"    value="{20, 5, 3}"/>
    </ParameterList>
    <ParameterList name="indenter">
      <Parameter name="recipe"   type="string"        value="block"/>
      <Parameter name="size"     type="Array(double)" value="{1, 1, 1}"/>
      <Parameter name="elements" type="Array(int)"    value="{4, 4, 4}"/>
      <Parameter name="origin"   type="Array(double)" value="{1, 1.5, 3}"/>
    </ParameterList>
  </ParameterList>

  <ParameterList name="materials">
    <ParameterList name="soft">
      <Parameter name="model"          type="string" value="neo-hookean"/>      <!-- thesis 3.130 -->
      <Parameter name="youngs modulus" type="double" value="1"/>
      <Parameter name="poissons ratio" type="double" value="0.3"/>
    </ParameterList>
    <ParameterList name="stiff">
      <Parameter name="model"          type="string" value="neo-hookean"/>
      <Parameter name="youngs modulus" type="double" value="1000"/>
      <Parameter name="poissons ratio" type="double" value="0.3"/>
    </ParameterList>
  </ParameterList>

  <ParameterList name="bodies">                      <!-- a body: blocks, material, element formulation -->
    <ParameterList name="slab">
      <Parameter name="mesh"     type="string" value="slab"/>
      <Parameter name="material" type="string" value="soft"/>
    </ParameterList>
    <ParameterList name="indenter">
      <Parameter name="mesh"     type="string" value="indenter"/>
      <Parameter name="material" type="string" value="stiff"/>
    </ParameterList>
  </ParameterList>

  <ParameterList name="supports">                    <!-- prescribed displacement; a component left out is free. set = mesh name / side or node set (name or number);
                                                          sides of a block: left right (x), front back (y), bottom top (z) -->
    <ParameterList name="slab bottom">
      <Parameter name="set" type="string" value="slab/bottom"/>
      <Parameter name="x"   type="string" value="0"/>
      <Parameter name="y"   type="string" value="0"/>
      <Parameter name="z"   type="string" value="0"/>
    </ParameterList>
    <ParameterList name="indenter top">
      <Parameter name="set" type="string" value="indenter/top"/>
      <Parameter name="x"   type="string" value="0.15*max(t-1,0)"/>
      <Parameter name="y"   type="string" value="0"/>
      <Parameter name="z"   type="string" value="-0.7*min(t,1)"/>
    </ParameterList>
  </ParameterList>

  <ParameterList name="contact">
    <ParameterList name="indenter on slab">
      <Parameter name="secondary" type="string" value="indenter/bottom"/>
      <Parameter name="primary"   type="string" value="slab/top"/>
      <Parameter name="method"    type="string" value="mortar"/>
      <!-- no "friction coefficient": frictionless; nothing tangential exists -->
    </ParameterList>
  </ParameterList>

  <ParameterList name="time">
    <Parameter name="scheme"       type="string" value="static"/>
    <Parameter name="end"          type="double" value="20"/>
    <Parameter name="step"         type="double" value="0.1"/>
    <Parameter name="largest step" type="double" value="0.5"/>
    <Parameter name="stops"        type="Array(double)" value="{1}"/>
  </ParameterList>

  <ParameterList name="output">
    <Parameter name="fields" type="Array(string)" value="{displacement, von mises, contact pressure, gap, status}"/>
  </ParameterList>

  <ParameterList name="expected">
    <ParameterList name="pressing force">
      <Parameter name="quantity"  type="string" value="contact_force_z.indenter on slab"/>
      <Parameter name="at time"   type="double" value="1"/>
      <Parameter name="value"     type="double" value="1.722"/>
      <Parameter name="tolerance" type="double" value="0.05"/>
      <Parameter name="source"    type="string" value="independent prototype, standard multipliers on the indenter"/>
    </ParameterList>
    <ParameterList name="sliding force">
      <Parameter name="quantity"  type="string" value="contact_force_z.indenter on slab"/>
      <Parameter name="mean from" type="double" value="5"/>
      <Parameter name="value"     type="double" value="1.713"/>
      <Parameter name="tolerance" type="double" value="0.045"/>
      <Parameter name="source"    type="string" value="independent prototype, standard multipliers on the indenter"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
)deck";

/// A short complete deck; tests change it.
inline const std::string block_deck = R"deck(<ParameterList name="block">
  <ParameterList name="meshes">
    <ParameterList name="cube">
      <Parameter name="recipe" type="string" value="block"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="materials">
    <ParameterList name="rubber">
      <Parameter name="model" type="string" value="neo-hookean"/>
      <Parameter name="youngs modulus" type="double" value="2.5"/>
      <Parameter name="poissons ratio" type="double" value="0.25"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="bodies">
    <ParameterList name="cube">
      <Parameter name="mesh" type="string" value="cube"/>
      <Parameter name="material" type="string" value="rubber"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="supports">
    <ParameterList name="bottom">
      <Parameter name="set" type="string" value="cube/bottom"/>
      <Parameter name="z" type="string" value="0"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="time">
    <Parameter name="end" type="double" value="2"/>
    <Parameter name="step" type="double" value="0.5"/>
  </ParameterList>
</ParameterList>
)deck";

/// The parameters of the material of `block_deck`, from the 9th line, 7th column on.
inline const std::string elastic_parameters = R"deck(<Parameter name="model" type="string" value="neo-hookean"/>
      <Parameter name="youngs modulus" type="double" value="2.5"/>
      <Parameter name="poissons ratio" type="double" value="0.25"/>)deck";

inline std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

/// `text` with the first place of `from` replaced. @throws std::logic_error if there is no such place
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the deck has no " + from);
  return text.replace(at, from.size(), to);
}

/// `block_deck` with further top lists before its end; they begin at line 29.
inline std::string with_lists(const std::string& lists) {
  std::string text = block_deck;
  return text.insert(text.rfind("</ParameterList>"), lists + "\n");
}

/// A folder of this process, gone when it ends.
struct Folder {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / ("mortise_deck_" + std::to_string(getpid()));
  Folder() { std::filesystem::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

/// Writes a file into the folder of this process. @return its path
inline std::filesystem::path write_file(const std::string& text, const std::string& name = "deck.xml") {
  static const Folder folder;
  std::ofstream(folder.path / name, std::ios::binary) << text;
  return folder.path / name;
}

inline DeckOptions read_text(const std::string& text) { return Deck::read(write_file(text)).options(); }

/// Every message of a deck that must be refused with exit code 2, without the folder; empty if it is accepted.
inline std::string errors_of(const std::string& text) {
  const std::filesystem::path file = write_file(text);
  try {
    Deck::read(file);
  } catch (const DeckError& error) {
    EXPECT_EQ(error.code(), ExitCode::deck);
    std::string messages = error.what();
    const std::string folder = file.parent_path().string() + "/";
    for (std::size_t at = messages.find(folder); at != std::string::npos; at = messages.find(folder)) {
      messages.erase(at, folder.size());
    }
    return messages;
  }
  return "";
}

inline std::size_t count_lines(const std::string& text) {
  return text.empty() ? 0 : 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace mortise::test
