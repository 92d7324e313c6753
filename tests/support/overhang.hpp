// Two small blocks whose meshes do not match, the upper one turned and hanging over the lower one's edge: nodes with full, part
// and no cover.
#pragma once

#include <string>

namespace mortise::test {

inline const std::string overhang_deck = R"deck(<ParameterList name="overhang">
  <ParameterList name="meshes">
    <ParameterList name="lower">
      <Parameter name="recipe"   type="string"        value="block"/>
      <Parameter name="size"     type="Array(double)" value="{3, 3, 1}"/>
      <Parameter name="elements" type="Array(int)"    value="{3, 3, 1}"/>
    </ParameterList>
    <ParameterList name="upper">
      <Parameter name="recipe"   type="string"        value="block"/>
      <Parameter name="size"     type="Array(double)" value="{2.4, 2.4, 1}"/>
      <Parameter name="elements" type="Array(int)"    value="{4, 4, 1}"/>
      <Parameter name="origin"   type="Array(double)" value="{1.6, 0.15, 1.01}"/>
      <Parameter name="rotation" type="Array(double)" value="{0, 0, 1, 17}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="materials">
    <ParameterList name="rubber">
      <Parameter name="model"          type="string" value="neo-hookean"/>
      <Parameter name="youngs modulus" type="double" value="1"/>
      <Parameter name="poissons ratio" type="double" value="0.3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="bodies">
    <ParameterList name="lower">
      <Parameter name="mesh"     type="string" value="lower"/>
      <Parameter name="material" type="string" value="rubber"/>
    </ParameterList>
    <ParameterList name="upper">
      <Parameter name="mesh"     type="string" value="upper"/>
      <Parameter name="material" type="string" value="rubber"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="supports">
    <ParameterList name="lower bottom">
      <Parameter name="set" type="string" value="lower/bottom"/>
      <Parameter name="x"   type="string" value="0"/>
      <Parameter name="y"   type="string" value="0"/>
      <Parameter name="z"   type="string" value="0"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="contact">
    <ParameterList name="pair">
      <Parameter name="secondary" type="string" value="upper/bottom"/>
      <Parameter name="primary"   type="string" value="lower/top"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="time">
    <Parameter name="end"  type="double" value="1"/>
    <Parameter name="step" type="double" value="1"/>
  </ParameterList>
</ParameterList>
)deck";

}  // namespace mortise::test
