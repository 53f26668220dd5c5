// A folder for the tests of a file.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after } from "node:test";

/** The path of a new folder, which is removed behind the tests. */
export function scratchFolder() {
  const folder = mkdtempSync(join(tmpdir(), "stridor-"));
  after(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
