/** Resolved cases. Each of several joints has the keys of [joint] and [contact] below its name: "joint.lip2.mass". */
import type { Case, Field, JointPart, Preset, Section } from "./types.ts";
import type { OwnContact } from "../program/words.ts";

/** The joints of a case with several; none for a case with one, whose keys need no name. */
export function jointsOf(resolved: Case): JointPart[] {
  return Array.isArray(resolved.joint) ? resolved.joint : [];
}

/** Has it a structure of its own, in the place of joint and plate? */
export function hasStructure(resolved: Case): boolean {
  return typeof resolved.structure === "object";
}

/** The contacts of a structure of its own; none of joints on a plate. */
export function contactsOf(resolved: Case): OwnContact[] {
  const { structure } = resolved;
  if (typeof structure !== "object" || Array.isArray(structure)) return [];
  return structure.contacts as OwnContact[];
}

/** What rubs, in a word. */
export function rubbing(resolved: Case): "joint" | "contact" {
  return hasStructure(resolved) ? "contact" : "joint";
}

/** What of a case can be heard: the name that the server takes, and what it is called here. */
export function heardIn(resolved: Case): (readonly [string, string])[] {
  if (!hasStructure(resolved)) {
    const joints = jointsOf(resolved).map(({ name }) => [name, name] as const);
    return [["joint", joints.length > 1 ? "strongest joint" : "joint"], ["plate", "plate"], ...joints];
  }
  const { outputs } = resolved.structure as Section;
  const names = [...((outputs ?? []) as string[]), ...contactsOf(resolved).map(({ name }) => name)];
  // without outputs the strongest contact is heard, with them the first one
  return outputs || names.length < 2
    ? names.map((name) => [name, name] as const)
    : [["joint", "strongest contact"], ...names.map((name) => [name, name] as const)];
}

/** Where each contact of an own structure is along the line of contacts [1], from 0 to 1; in order where unknown. */
export function placesOf(contacts: readonly OwnContact[]): number[] {
  const along = contacts.map((contact, k) => contact.along_line ?? k);
  const length = Math.max(...along);
  return along.map((place) => (length > 0 ? place / length : 0.5));
}

/** A key of one of several joints: whose, and the key that it is where there is one joint only. */
export function jointKey(key: string): { joint: string; inner: string } | null {
  const [, joint, rest] = /^joint\.([^.]+)\.(.+)$/.exec(key) ?? [];
  if (joint === undefined || rest === undefined) return null;
  return { joint, inner: rest.startsWith("contact.") ? rest : `joint.${rest}` };
}

/** The key of one of several joints for what "joint.mass" or "contact.preload" is where there is one. */
export function keyOfJoint(joint: string, inner: string): string {
  return `joint.${joint}.${inner.replace(/^joint\./, "")}`;
}

/** Is a key that of all joints of a case with several? */
export function isOfJoints(resolved: Case, key: string): boolean {
  return jointsOf(resolved).length > 1 && !jointKey(key) && /^(joint|contact)\./.test(key);
}

/** Where the value of a key stands: of one of several joints in the list of them. */
function partIn(resolved: Case, key: string): { part: Section | undefined; name: string } {
  const own = jointKey(key);
  const [section = "", name = ""] = (own?.inner ?? key).split(".", 2);
  if (own) {
    const joint = jointsOf(resolved).find((each) => each.name === own.joint);
    return { part: section === "contact" ? joint?.contact : (joint as Section | undefined), name };
  }
  const part = resolved[section];
  return { part: typeof part === "object" && !Array.isArray(part) ? part : undefined, name };
}

/** The value of a key in a resolved case. */
export function valueIn(resolved: Case, key: string): number | string | undefined {
  const { part, name } = partIn(resolved, key);
  const value = part?.[name];
  return typeof value === "object" ? undefined : value;
}

/** The fields with those of each joint that a preset names, in front of what all of them share. */
export function withJoints(fields: readonly Field[], presets: readonly Preset[]): Field[] {
  const names = new Set(presets.flatMap((preset) => jointsOf(preset.case).map(({ name }) => name)));
  const ofJoint = fields.filter(({ section }) => section === "joint" || section === "contact");
  const own = [...names].flatMap((name) =>
    ofJoint.map((field) => {
      const section = field.section === "contact" ? `joint.${name}.contact` : `joint.${name}`;
      return { ...field, key: keyOfJoint(name, field.key), section };
    }),
  );
  return [...own, ...fields];
}
