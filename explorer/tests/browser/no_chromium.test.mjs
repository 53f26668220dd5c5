// Stands for the tests in Chromium where there is none: left out, or failed in a continuous-integration run.
import { test } from "node:test";
import { lacking } from "./needs.mjs";

test("the page works in Chromium", { skip: lacking(false, "Chromium", "chromium") });
