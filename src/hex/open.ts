import { freeLibraries } from '#libraries/index';
import { nameProblem, type SourceFile } from '#project/project';
import { robotTypes } from '#robots/index';
import type { HexProblem } from './firmware';
import type { ReadHex } from './hex';
import { readHex } from './read';
import { STAND_IN } from './stand-in';

/** The pupil's work in a hex. */
export interface OpenedHex {
  readonly hex: ReadHex;
  /** The pupil's files, main.py first. */
  readonly files: readonly SourceFile[];
  /** Names of modules that are here anyway, and were left out. */
  readonly ours: readonly string[];
  /** Files that a project cannot hold: they are no text, or have no name for one. */
  readonly unfit: readonly string[];
}

/** Reads a hex as work: without the modules that are here anyway. Never throws. */
export function openHex(text: string): OpenedHex | { readonly problem: HexProblem } {
  const hex = readHex(text);
  if (hex.kind === 'problem') return hex;
  const known = ownModules();
  const files: SourceFile[] = [];
  const [ours, unfit]: [string[], string[]] = [[], []];
  for (const note of hex.notes) if (note.code === 'not-text') unfit.push(note.file);
  for (const { name, text: content } of hex.files) {
    if (known.has(name)) ours.push(name);
    else if (nameProblem(name, files) !== null) unfit.push(name);
    else files.push({ name, text: content.replaceAll('\r\n', '\n') });
  }
  return { hex, files, ours, unfit };
}

/** The names of all files that we bring along for a board. */
function ownModules(): ReadonlySet<string> {
  const modules = robotTypes.flatMap((type) => [...type.modules, ...Object.keys(type.sameModules ?? {})]);
  return new Set([...Object.keys(freeLibraries), STAND_IN.name, ...modules.map((name) => `${name}.py`)]);
}
