import { existsSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { isRecord } from '#core/record';
import type { RunEnd } from '#lab/run-end';
import type { Sweep } from '#lab/sweep';
import type { SweepRun } from '#lab/sweep-texts';
import type { Base, Value } from '#lab/what';
import { version } from '../../../package.json';
import { KeptFolder, keyOf } from '../kept-folder';
import { reasonOf } from '../reason-of';
import { replaceFile } from '../write-output';

type Problem = { readonly problem: string };

/** The description of the sweep, and the folder of its runs, one file each. */
const [SWEEP, RUNS] = ['sweep.json', 'runs'];

/** The sweep of a folder. */
export interface FolderSweep {
  /** Name of the program. */
  readonly name: string;
  readonly varied: readonly { readonly name: string; readonly values: readonly Value[] }[];
  readonly count: number;
  /** Hash of everything on which the runs depend. */
  readonly key: string;
}

/** Describes a sweep for its folder. */
export function folderSweep(name: string, { varied, count }: Sweep, base: Base, end: RunEnd): FolderSweep {
  const names = varied.map((one) => ({ name: one.name, values: one.values }));
  const { setup, usedSeed, idealSeed = null } = base;
  const whats = varied.map(({ what }) => what);
  return { name, varied: names, count, key: keyOf(version, names, whats, setup, usedSeed, idealSeed, end) };
}

/** A folder with a file for each run. */
export class RunsFolder {
  private readonly runs: KeptFolder;

  private constructor(
    private readonly path: string,
    readonly sweep: FolderSweep,
  ) {
    this.runs = new KeptFolder(join(path, RUNS));
  }

  /** Opens a folder for the runs of a sweep; makes it if it does not exist. */
  static open(path: string, sweep: FolderSweep): RunsFolder | Problem {
    try {
      const folder = new RunsFolder(path, sweep);
      folder.runs.make();
      const here = join(path, SWEEP);
      const kept = existsSync(here) ? readSweepFile(here) : sweep;
      if (kept?.key !== sweep.key)
        return { problem: `${path}: holds the runs of another sweep. Choose another folder.` };
      replaceFile(here, `${JSON.stringify(sweep)}\n`);
      return folder;
    } catch (error) {
      return { problem: `${path}: ${reasonOf(error)}` };
    }
  }

  /** The runs of a folder, those of all shards. */
  static read(path: string): RunsFolder | Problem {
    try {
      if (!statSync(path).isDirectory()) return { problem: `${path}: is no folder.` };
      const sweep = readSweepFile(join(path, SWEEP));
      return sweep === null ? { problem: `${path}: ${SWEEP} is damaged.` } : new RunsFolder(path, sweep);
    } catch (error) {
      return { problem: `${path}: is no folder of runs: ${reasonOf(error)}` };
    }
  }

  /** The file with the description, which is rewritten. */
  static readonly sweepIn = (path: string): string => join(path, SWEEP);

  /** All its files. */
  files(): readonly string[] {
    return [join(this.path, SWEEP), ...this.runs.files()];
  }

  /** The run at a place, if it is stored; a damaged one, or one of another sweep, counts as missing. */
  find(place: number): SweepRun | null {
    const kept = this.runs.find(nameOf(place));
    return isKept(kept) && kept.key === this.sweep.key ? kept.run : null;
  }

  keep(place: number, run: SweepRun): void {
    this.runs.keep(nameOf(place), { key: this.sweep.key, run } satisfies Kept);
  }
}

const nameOf = (place: number): string => String(place + 1).padStart(6, '0');

/** The file of a run. */
interface Kept {
  readonly key: string;
  readonly run: SweepRun;
}

const isKept = (value: unknown): value is Kept =>
  isRecord(value) &&
  typeof value['key'] === 'string' &&
  isRecord(value['run']) &&
  Array.isArray(value['run']['values']);

function readSweepFile(path: string): FolderSweep | null {
  const text = readFileSync(path, 'utf8');
  try {
    const value: unknown = JSON.parse(text);
    return isSweep(value) ? value : null;
  } catch {
    return null;
  }
}

const isSweep = (value: unknown): value is FolderSweep =>
  isRecord(value) &&
  typeof value['name'] === 'string' &&
  typeof value['key'] === 'string' &&
  Number.isInteger(value['count']) &&
  Array.isArray(value['varied']) &&
  value['varied'].every((one) => isRecord(one) && typeof one['name'] === 'string' && Array.isArray(one['values']));
