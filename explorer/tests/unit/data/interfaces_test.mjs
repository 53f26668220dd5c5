import assert from "node:assert/strict";
import { test } from "node:test";
import { worstFirst } from "../../../src/data/interfaces.ts";

const contact = (name, category, level) => ({
  name,
  verdict: category && { category, levels: { joint: { level } } },
});

test("the noisiest contact comes first, of alike ones the loudest, what carries nothing last", () => {
  const contacts = [
    contact("open", null),
    contact("still", "none", null),
    contact("soft", "squeal", 80),
    contact("creaks", "creak", 150),
    contact("loud", "squeal", 120),
    contact("slides", "none", 60),
  ];
  const load = { name: "loud", normal_force: 2, load_share: 0.5, friction_power: 0.1, is_loaded: true };
  const rows = worstFirst({ contacts, interfaces: [{ contacts: [load] }] });
  assert.deepEqual(
    rows.map(({ name }) => name),
    ["loud", "soft", "creaks", "slides", "still", "open"],
  );
  assert.equal(rows[0].load, load);
  assert.equal(rows[0].index, 4);
  assert.equal(rows[1].load, undefined);
  assert.deepEqual(worstFirst({}), []);
});
