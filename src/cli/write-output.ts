import {
  closeSync,
  fstatSync,
  ftruncateSync,
  openSync,
  realpathSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
  writeSync,
} from 'node:fs';
import { resolve } from 'node:path';

/** The two that are printed on, open already: a file behind them, opened anew, would be emptied under the printed lines. */
const STANDARD: Readonly<Record<string, number>> = { '/dev/stdout': 1, '/dev/stderr': 2 };

/** Chosen: a reader that is slow is asked again soon, and nobody sees the wait. */
const WAIT_MS = 5;

/** Opens a file to be written later, without emptying it. Those of `STANDARD` are open already. */
export const openOutput = (path: string): number => STANDARD[resolve(path)] ?? openSync(path, 'a');

/** Closes it; what is printed on stays open. */
export function closeOutput(file: number): void {
  if (!isStandard(file)) closeSync(file);
}

const isStandard = (file: number): boolean => Object.values(STANDARD).includes(file);

/** Empties an open file; what is printed on, a pipe or a terminal cannot be emptied and need not be. */
export function emptyOutput(file: number): void {
  if (!isStandard(file) && fstatSync(file).isFile()) ftruncateSync(file);
}

/** Writes all of a text to an open file, also where a pipe takes only a part at once. */
export function writeAll(file: number, text: string): void {
  const bytes = Buffer.from(text);
  for (let done = 0; done < bytes.length;) {
    try {
      done += writeSync(file, bytes, done);
    } catch (error) {
      if (!(error instanceof Error && 'code' in error && error.code === 'EAGAIN')) throw error;
      Atomics.wait(new Int32Array(new SharedArrayBuffer(Int32Array.BYTES_PER_ELEMENT)), 0, 0, WAIT_MS);
    }
  }
}

/**
 * Writes a file whole: where that fails, such as on a full disk, an earlier file keeps what it had. Links lead where they
 * led, and rights stay.
 *
 * @throws Error of the system if it cannot be written
 */
export function writeOutput(path: string, text: string): void {
  const standard = STANDARD[resolve(path)];
  if (standard !== undefined) return writeAll(standard, text);
  const found = statSync(path, { throwIfNoEntry: false });
  if (found === undefined) return replaceFile(path, text);
  const isOwn = found.isFile() && found.nlink === 1 && found.uid === (process.getuid?.() ?? found.uid);
  if (!isOwn) return writeFileSync(path, text);
  try {
    replaceFile(realpathSync(path), text, found.mode);
  } catch (error) {
    if (!(error instanceof Error && 'code' in error && DRAFT_REFUSED.includes(String(error.code)))) throw error;
    writeFileSync(path, text);
  }
}

/** Codes that say that beside the file nothing may be written; the file itself may be. */
const DRAFT_REFUSED = ['EACCES', 'EPERM', 'EROFS', 'EBUSY', 'ENAMETOOLONG'];

/** Writes a file in one step, so that no reader sees half of it. */
export function replaceFile(path: string, text: string, mode = 0o666): void {
  const draft = `${path}.${process.pid}.tmp`;
  try {
    writeFileSync(draft, text, { mode });
    renameSync(draft, path);
  } catch (error) {
    rmSync(draft, { force: true });
    throw error;
  }
}
