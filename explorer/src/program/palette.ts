/** The colours of Stridor's figures. Written by `stridor explore --typescript palette`, not by hand. */

/** The ground and the marks of each kind of cell; `failed` has no result. */
export const kindFills = {
  "none": { ground: "#E6E6E6", texture: "plain", mark: "#E6E6E6" },
  "squeak": { ground: "#DDAA33", texture: "dots", mark: "#7A5500" },
  "squeal": { ground: "#BB5566", texture: "rising", mark: "#E8B4BC" },
  "creak": { ground: "#004488", texture: "falling", mark: "#6F9CCC" },
  "undecided": { ground: "#FFFFFF", texture: "dots", mark: "#666666" },
  "none (sticks)": { ground: "#C4CCD4", texture: "plain", mark: "#C4CCD4" },
  "locks": { ground: "#9AA2AB", texture: "crossed", mark: "#4A525C" },
  "failed": { ground: "#FFFFFF", texture: "crossed", mark: "#888888" },
} as const;

/** Of each state of the contact. */
export const stateColours = { slip: "#88CCEE", stick: "#7A7A00", separation: "#301030" } as const;

/** The map of figures, from the lowest value to the highest, at equal distances. */
export const sequentialStops = [
  "#440154",
  "#482576",
  "#414487",
  "#355F8D",
  "#2A788E",
  "#21918C",
  "#22A884",
  "#44BF70",
  "#7AD151",
  "#BDDF26",
  "#FDE725",
] as const;
