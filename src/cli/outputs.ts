import { existsSync, realpathSync, statSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { formatOf } from '#intake/formats';

/** An output file of a command. */
export interface Output {
  /** The option for it as it is typed, such as `--csv`. */
  readonly option: string;
  /** `null`: the option was not given. */
  readonly path: string | null;
}

/**
 * Finds the problem with files that a command is to write, `null` for none: no file may be one that it reads, under
 * any name or link, nor a program, nor the same as another one. Any number of outputs may go to /dev/null and its like.
 *
 * @param reads files that the command reads; missing ones are ignored
 */
export function outputProblem(outputs: readonly Output[], reads: readonly string[], command: string): string | null {
  const asked = outputs.flatMap(({ option, path }) => (path === null ? [] : [{ option, path }]));
  const program = asked.find(({ path }) => formatOf(path) === 'program');
  if (program !== undefined) return `${program.option}: ${program.path} is called like a program. Choose another name.`;
  const wanted = asked.filter(({ path }) => !existsSync(path) || statSync(path).isFile());
  if (wanted.length === 0) return null;
  const known = new Set(reads.filter((path) => existsSync(path)).flatMap(identities));
  for (const [place, { option, path }] of wanted.entries()) {
    const own = identities(path);
    if (own.some((one) => known.has(one))) return `${option}: ${path} is read by this ${command}. Choose another name.`;
    const other = wanted.slice(0, place).find((one) => identities(one.path).some((id) => own.includes(id)));
    if (other !== undefined)
      return `${other.option} and ${option}: ${path} can be only one of them. Choose another name.`;
  }
  return null;
}

/** True if two names mean one file, also through links. */
export function isSameFile(one: string, other: string): boolean {
  const own = identities(one);
  return identities(other).some((identity) => own.includes(identity));
}

/** Identities of a file, equal for two names of one file: its path behind links, and its number on its disk. */
function identities(path: string): readonly string[] {
  try {
    const { dev, ino } = statSync(path, { bigint: true });
    return [realpathSync(path), ...(ino === 0n ? [] : [`${dev}:${ino}`])];
  } catch {
    return [placeOf(path)];
  }
}

/** The future path of a file that does not exist yet. */
function placeOf(path: string): string {
  try {
    return join(realpathSync(dirname(resolve(path))), basename(path));
  } catch {
    return resolve(path);
  }
}
