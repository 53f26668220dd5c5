// What a test needs and a machine may lack (tests/support/needs.hpp is the same for C++).

/**
 * The `skip` of a test: false, or what is not there and what to install. A continuous-integration run installs
 * everything: there it throws, since a hole in such a run would be seen by nobody.
 */
export function lacking(isThere, what, packages) {
  if (isThere) return false;
  const why = `${what} is not there: apt-get install ${packages}`;
  if (process.env.CI) throw new Error(why);
  return why;
}
