/**
 * Opens the links that WebTigerPython shares: `code` is the list of files `[{ "name": "main.py", "data": "…" }]` as JSON,
 * packed with LZ-String into base64 in the alphabet of addresses; `device` is the microcomputer's name. Both stand in the
 * query (`?code=…`) or, in newer links, in the fragment (`#?code=…`).
 */
import { defaultScene, SCENE_FORMAT, SCENE_VERSION } from '#scene/scene';

import { parseProjectValue, PROJECT_FORMAT, PROJECT_VERSION } from './file';
import { textOfLzBase64 } from './lz-string';
import type { ProjectProblem } from './problem';
import { FILE_BYTES, MAIN, type SourceFile } from './project';

/** The most characters a link may unpack to. */
const MAX_CHARACTERS = 4_000_000;

/** Longest link that is read. */
const MAX_LINK = 500_000;

/** WebTigerPython's names for the microcomputers that we have, and our ids. */
const DEVICES: Readonly<Record<string, string>> = {
  'micro:bit': 'microbit-v2',
  'Calliope mini 1/2': 'calliope-mini-2',
  'Calliope mini 3': 'calliope-mini-3',
};

/** The program in a link. */
export interface ProgramLink {
  /** main.py first. */
  readonly files: readonly SourceFile[];
  /** Id of the microcomputer it is for, or `null`: it does not say, or it is one that we do not have. */
  readonly device: string | null;
}

/** Why a link opens nothing. */
export interface ProgramLinkProblem {
  readonly code: 'damaged' | 'too-large' | 'too-long' | 'invalid';
  /** One English sentence with the way out. */
  readonly message: string;
  readonly params: Readonly<Record<string, string | number>>;
  /** What is wrong with the files of a link that is whole. */
  readonly problems: readonly ProjectProblem[];
}

/** Whether an address, or a part of one, has a program of WebTigerPython in it. */
export const hasProgram = (address: string): boolean => /[?&]code=/.test(address);

/** Reads a whole address, or its query or fragment. Never throws; a link with a problem opens nothing. */
export function programOfLink(address: string): ProgramLink | { readonly problem: ProgramLinkProblem } {
  if (address.length > MAX_LINK) {
    const params = { length: address.length, max: MAX_LINK };
    return failed(
      'too-long',
      `The link has ${String(address.length)} characters; the limit is ${String(MAX_LINK)}.`,
      params,
    );
  }
  const code = parameter(address, 'code');
  if (code === null || code === '') return damaged();
  const unpacked = textOfLzBase64(code, MAX_CHARACTERS);
  if (unpacked === 'too-large') {
    const what = `The link unpacks to more than ${String(MAX_CHARACTERS)} characters. It is not opened.`;
    return failed('too-large', what, { max: MAX_CHARACTERS });
  }
  const entries = unpacked === 'damaged' ? null : entriesOf(unpacked.text);
  if (entries === null) return damaged();
  const files = withMainFirst(entries);
  // Read like a project: the files of a link are judged by the same rules.
  const parsed = parseProjectValue({
    format: PROJECT_FORMAT,
    version: PROJECT_VERSION,
    files,
    scene: { format: SCENE_FORMAT, version: SCENE_VERSION, ...defaultScene() },
  });
  if ('problems' in parsed) {
    const what = `The program in the link cannot be opened: ${parsed.problem}`;
    return failed('invalid', what, { max: FILE_BYTES }, parsed.problems);
  }
  return { files: parsed.project.files, device: DEVICES[parameter(address, 'device') ?? ''] ?? null };
}

function failed(
  code: ProgramLinkProblem['code'],
  message: string,
  params: ProgramLinkProblem['params'],
  problems: readonly ProjectProblem[] = [],
): { readonly problem: ProgramLinkProblem } {
  return { problem: { code, message, params, problems } };
}

const damaged = (): { readonly problem: ProgramLinkProblem } =>
  failed('damaged', 'The link is damaged: a part of it is missing or changed. Copy it again, whole.', {});

/** A parameter of the query or of the fragment, decoded; `null`: not there, or not to be decoded. */
function parameter(address: string, name: string): string | null {
  for (const part of address.split(/[?&#]/)) {
    if (!part.startsWith(`${name}=`)) continue;
    try {
      return decodeURIComponent(part.slice(name.length + 1));
    } catch {
      return null;
    }
  }
  return null;
}

/** The list of files as it stands in the link; `null` when it is none. */
function entriesOf(json: string): readonly SourceFile[] | null {
  let value: unknown;
  try {
    value = JSON.parse(json);
  } catch {
    return null;
  }
  if (!Array.isArray(value)) return null;
  const files = value.map(fileOf);
  return files.length === 0 || files.includes(null) ? null : files.filter((file) => file !== null);
}

function fileOf(value: unknown): SourceFile | null {
  if (typeof value !== 'object' || value === null) return null;
  const { name, data } = value as { readonly name?: unknown; readonly data?: unknown };
  return typeof name === 'string' && typeof data === 'string' ? { name, text: data.replaceAll('\r\n', '\n') } : null;
}

/** The program is what stands in main.py; where none is called so, the first file is meant. */
function withMainFirst(files: readonly SourceFile[]): readonly SourceFile[] {
  const main = files.find(({ name }) => name === MAIN) ?? files[0];
  const others = files.filter((file) => file !== main);
  return main === undefined ? files : [{ name: MAIN, text: main.text }, ...others];
}
