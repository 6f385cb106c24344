/**
 * Opens the links that WebTigerPython shares: `code` is the list of files `[{ "name": "main.py", "data": "…" }]` as
 * JSON, packed with LZ-String into base64 in the alphabet of addresses; `device` is the microcomputer's name. Both
 * stand in the query (`?code=…`) or, in newer links, in the fragment (`#?code=…`). Its pages with several files have
 * `fs` instead of `code`: see `files-in-link.ts`.
 */
import { defaultScene, SCENE_FORMAT, SCENE_VERSION } from '#scene/scene';

import { parseProjectValue, PROJECT_FORMAT, PROJECT_VERSION } from '../file';
import { textOfLzBase64, type LzProblem } from './lz-string';
import type { ProjectProblem } from '../problem';
import { FILE_BYTES, type SourceFile } from '../project';
import { deviceCalled } from './device-names';
import { filesOfList, filesOfTree } from './files-in-link';

/** The maximum number of characters that a link may unpack to. */
const MAX_CHARACTERS = 4_000_000;

/** Longest link that is read. */
const MAX_LINK = 500_000;

/** The program in a link. */
export interface ProgramLink {
  /** main.py first. */
  readonly files: readonly SourceFile[];
  /** Id of the microcomputer it is for; `null` if the link does not say, or if we do not have it. */
  readonly device: string | null;
}

/** Why a link opens nothing. */
export interface ProgramLinkProblem {
  readonly code: 'damaged' | 'too-large' | 'too-long' | 'unknown-form' | 'invalid';
  /** One English sentence with the way out. */
  readonly message: string;
  readonly params: Readonly<Record<string, string | number>>;
  /** The faults of the files of an undamaged link. */
  readonly problems: readonly ProjectProblem[];
}

/** True if an address, or a part of one, has a program of WebTigerPython in it. */
export const hasProgram = (address: string): boolean => /[?&](code|fs)=/.test(address);

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
  const files = filesIn(address);
  if ('problem' in files) return files;
  // Read like a project: the same rules judge the files of a link.
  const parsed = parseProjectValue({
    format: PROJECT_FORMAT,
    version: PROJECT_VERSION,
    files: files.files,
    scene: { format: SCENE_FORMAT, version: SCENE_VERSION, ...defaultScene() },
  });
  if ('problems' in parsed) {
    const what = `The program in the link cannot be opened: ${parsed.problem}`;
    return failed('invalid', what, { max: FILE_BYTES }, parsed.problems);
  }
  return { files: parsed.project.files, device: deviceCalled(parameter(address, 'device') ?? '') };
}

/** The files as the link has them, main.py first. */
function filesIn(address: string): Pick<ProgramLink, 'files'> | { readonly problem: ProgramLinkProblem } {
  const code = parameter(address, 'code');
  const packed = code ?? parameter(address, 'fs');
  if (packed === null || packed === '') return damaged();
  const unpacked = valueOfPacked(packed);
  if (unpacked === 'too-large') {
    const what = `The link unpacks to more than ${String(MAX_CHARACTERS)} characters. It is not opened.`;
    return failed('too-large', what, { max: MAX_CHARACTERS });
  }
  if (unpacked === 'damaged') return damaged();
  const files = (code === null ? filesOfTree : filesOfList)(unpacked.value);
  if (files !== null) return { files };
  return code === null
    ? failed('unknown-form', 'The link has its files in a form that we do not know. It is not opened.', {})
    : damaged();
}

function valueOfPacked(packed: string): { readonly value: unknown } | LzProblem {
  const unpacked = textOfLzBase64(packed, MAX_CHARACTERS);
  if (typeof unpacked === 'string') return unpacked;
  try {
    return { value: JSON.parse(unpacked.text) as unknown };
  } catch {
    return 'damaged';
  }
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

/** A parameter of the query or of the fragment, decoded; `null` if it is missing or cannot be decoded. */
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
