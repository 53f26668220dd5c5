/** Resolved cases. Each of several joints has the keys of [joint] and [contact] below its name: "joint.lip2.mass". */
import type { Case, Field, JointPart, Preset, Section } from "./types.ts";

/** The joints of a case with several; none for a case with one, whose keys need no name. */
export function jointsOf(resolved: Case): JointPart[] {
  return Array.isArray(resolved.joint) ? resolved.joint : [];
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
