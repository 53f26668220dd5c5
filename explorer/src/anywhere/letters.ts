/** What the page and a worker of it write to each other. */

/** The first letter to a worker: the compiled core and the case it begins with, or null for the paper's. */
export interface Begin {
  module: WebAssembly.Module;
  opened: string | null;
}

/** A question. A worker has one at a time. */
export interface Question {
  path: string;
  body: string;
  /** The recording that the body names. */
  recording?: Uint8Array<ArrayBuffer>;
  /** To be answered by these results of helpers alone, or by the tasks for so many of them. */
  shared?: { results: Uint8Array; helpers: number };
  /** Tasks of the question, of which the results are wanted. */
  tasks?: Uint8Array;
}

/** Parts of an answer: the head, parts of the body, the end. A second head begins the answer anew. */
export type Letter =
  | { kind: "head"; status: number; type: string }
  | { kind: "part"; bytes: Uint8Array<ArrayBuffer> }
  | { kind: "end"; size: number } // [bytes] of memory that the worker has taken
  | { kind: "failed"; why: string; lacksMemory: boolean };
