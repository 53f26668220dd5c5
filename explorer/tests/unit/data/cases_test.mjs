import assert from "node:assert/strict";
import { test } from "node:test";
import { heardIn, jointKey, jointsOf, placesOf, rubbing, valueIn, withJoints } from "../../../src/data/cases.ts";

const one = { title: "one", joint: { mass: 0.1 }, contact: { preload: 20, friction: "coulomb" }, plate: { mass: 0.4 } };
const two = {
  title: "two",
  joint: [
    { name: "upper", mass: 0.1, contact: { preload: 20 } },
    { name: "lip-2", mass: 0.3, contact: { preload: 55 } },
  ],
  plate: { mass: 0.4 },
};

test("a key of one of several joints is whose, and what it is of one joint", () => {
  assert.deepEqual(jointKey("joint.lip-2.contact.preload"), { joint: "lip-2", inner: "contact.preload" });
  assert.deepEqual(jointKey("joint.upper.mass"), { joint: "upper", inner: "joint.mass" });
  for (const key of ["joint.mass", "contact.preload", "plate.mass", "joint."]) assert.equal(jointKey(key), null);
});

test("values stand below their section, of several joints in their list", () => {
  assert.equal(valueIn(one, "joint.mass"), 0.1);
  assert.equal(valueIn(one, "contact.friction"), "coulomb");
  assert.equal(valueIn(one, "joint.upper.mass"), undefined);
  assert.equal(valueIn(two, "joint.lip-2.mass"), 0.3);
  assert.equal(valueIn(two, "joint.lip-2.contact.preload"), 55);
  assert.equal(valueIn(two, "plate.mass"), 0.4);
  // what is a joint's has no value of its own beside the joints
  for (const key of ["joint.mass", "contact.preload", "joint.third.mass", "joint.upper.contact"])
    assert.equal(valueIn(two, key), undefined, key);
  assert.deepEqual(jointsOf(one), []);
  assert.equal(jointsOf(two).length, 2);
});

test("each joint of a preset has its own fields, in front of those of one", () => {
  const field = (section, name) => ({ key: `${section}.${name}`, section, symbol: "", sentence: "", kind: "quantity" });
  const fields = [field("joint", "mass"), field("plate", "mass"), field("contact", "preload")];
  const presets = [
    { name: "squeal", title: "", case: one },
    { name: "file", title: "", case: two },
  ];
  const all = withJoints(fields, presets);
  assert.deepEqual(
    all.map(({ key }) => key),
    [
      "joint.upper.mass",
      "joint.upper.contact.preload",
      "joint.lip-2.mass",
      "joint.lip-2.contact.preload",
      "joint.mass",
      "plate.mass",
      "contact.preload",
    ],
  );
  assert.equal(all[1].section, "joint.upper.contact");
  assert.deepEqual(withJoints(fields, presets.slice(0, 1)), fields);
});

const structure = (contacts, more = {}) => ({ title: "own", structure: { contacts, ...more } });

test("contacts stand where the case says they are along the line, else in their order", () => {
  const at = (along_line) => ({ name: "c", along_line });
  assert.deepEqual(placesOf([at(4), at(0), at(1)]), [1, 0, 0.25]);
  assert.deepEqual(placesOf([{ name: "a" }, { name: "b" }, { name: "c" }]), [0, 0.5, 1]);
  assert.deepEqual(placesOf([{ name: "c" }]), [0.5]);
});

test("what is heard of a case has a name that the server takes", () => {
  const names = (resolved) => heardIn(resolved).map(([name]) => name);
  assert.deepEqual(names({ title: "", joint: {} }), ["joint", "plate"]);
  assert.deepEqual(names({ title: "", joint: [{ name: "lip1" }, { name: "lip2" }] }), [
    "joint",
    "plate",
    "lip1",
    "lip2",
  ]);
  const two = [{ name: "a" }, { name: "b" }];
  assert.deepEqual(names(structure(two)), ["joint", "a", "b"]);
  assert.deepEqual(names(structure([{ name: "a" }])), ["a"]);
  assert.deepEqual(names(structure(two, { outputs: ["ear"] })), ["ear", "a", "b"]);
  assert.equal(rubbing(structure(two)), "contact");
  assert.equal(rubbing({ title: "" }), "joint");
});
