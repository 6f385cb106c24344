/**
 * The names of programs: those of their files; where some would be equal, with the folders before them that tell them apart, and
 * the same file twice with a number.
 *
 * @param paths of the files, with `/` between folders
 */
export function programNames(paths: readonly string[]): readonly string[] {
  const parts = paths.map((path) => path.split('/').filter((part) => part !== ''));
  const deepest = Math.max(1, ...parts.map(({ length }) => length));
  let names = parts.map((all) => all.slice(-1).join('/'));
  for (let depth = 2; depth <= deepest; depth++) {
    const before = names;
    names = names.map((name, place) =>
      before.filter((one) => one === name).length > 1 ? (parts[place] ?? []).slice(-depth).join('/') : name,
    );
  }
  return names.map((name, place) => {
    const earlier = names.slice(0, place).filter((one) => one === name).length;
    return earlier === 0 ? name : `${name} (${earlier + 1})`;
  });
}
