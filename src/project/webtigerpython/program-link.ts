/**
 * Opens the links that WebTigerPython shares: `code` is the list of files `[{ "name": "main.py", "data": "…" }]` as
 * JSON, packed with LZ-String into base64 in the alphabet of addresses; `device` is the microcomputer's name;
 * `playground` is the world of the simulated robot, packed in the same way (`world.ts`). They stand in the query
 * (`?code=…`) or, in newer links, in the fragment (`#?code=…`). Its pages with several files have `fs` instead of `code`:
 * see `files-in-link.ts`. Whatever happens to base64 on its way is understood: no padding, `%2B`, a `+` that became a space,
 * the alphabet of addresses.
 */
import { defaultScene, SCENE_FORMAT, SCENE_VERSION } from '#scene/scene';

import { parseProjectValue, PROJECT_FORMAT, PROJECT_VERSION } from '../file';
import { textOfLzBase64, type LzProblem } from './lz-string';
import type { ProjectProblem } from '../problem';
import { FILE_BYTES, type SourceFile } from '../project';
import { deviceCalled } from './device-names';
import { filesOfList, filesOfTree } from './files-in-link';
import { note, type Note } from './note';
import { notesOfParameters, parametersOf, type Parameters } from './parameters';
import { readWorld, type World } from './read-world';

/** The maximum number of characters that a program, and a world, may unpack to. */
const MAX_CHARACTERS = 4_000_000;
/** Chosen: more than ten times a world with as many things as a course may hold. */
const MAX_WORLD_CHARACTERS = 1_000_000;

/** Longest packed program, and longest packed world, that is unpacked, in characters. */
export const MAX_PACKED = 500_000;

/** Longest link that is looked at. Chosen: twice what it can hold. */
const MAX_LINK = 2_000_000;

/** A link's program, its world, or both. */
export interface ProgramLink {
  /** main.py first; none: the link has a world alone. */
  readonly files: readonly SourceFile[];
  /** Id of the microcomputer it is for; `null` if the link does not say, or if we do not have it. */
  readonly device: string | null;
  /** `null`: the link has none, or none that can be read; then a note says so. */
  readonly world: World | null;
  /** Tell of everything that could not be taken over; those of its world are in `world`. */
  readonly notes: readonly Note[];
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

type Failed = { readonly problem: ProgramLinkProblem };

/** True if an address, or a part of one, has a program or a world of WebTigerPython in it. */
export const isProgramLink = (address: string): boolean => /[?&](code|fs|playground)=/.test(address);

/**
 * Reads a whole address, or its query or fragment. Never throws; a link with a problem opens nothing, except that a damaged
 * program leaves its world whole.
 */
export function programOfLink(address: string): ProgramLink | Failed {
  if (address.length > MAX_LINK) return tooLong(address.length, MAX_LINK);
  const parameters = parametersOf(address);
  const { world, problem } = worldIn(parameters);
  const packed = parameters.get('code') === '' ? undefined : parameters.get('code');
  const hasFiles = packed !== undefined || (parameters.get('fs') ?? '') !== '';
  const files = hasFiles ? filesIn(parameters) : { files: [] };
  const isWorldAlone = 'problem' in files && files.problem.code === 'damaged' && world !== null;
  if ('problem' in files && !isWorldAlone) return files;
  if (!hasFiles && world === null) return problem === 'worldTooLarge' ? tooLarge(MAX_WORLD_CHARACTERS) : damaged();
  const lost = problem ?? (isWorldAlone ? 'programDamaged' : null);
  const notes = [...(lost === null ? [] : [note(lost)]), ...notesOfParameters(parameters)];
  const device = deviceCalled(parameters.get('device') ?? '');
  return { files: 'files' in files ? files.files : [], device, world, notes };
}

/** The world, or the note that it cannot be read; neither: there is none. */
function worldIn(parameters: Parameters): { world: World | null; problem: WorldProblem | null } {
  const packed = parameters.get('playground');
  if (packed === undefined || packed === '') return { world: null, problem: null };
  const unpacked = packed === null ? 'damaged' : valueOfPacked(packed, MAX_WORLD_CHARACTERS);
  if (unpacked === 'damaged') return { world: null, problem: 'worldDamaged' };
  if (typeof unpacked === 'string') return { world: null, problem: 'worldTooLarge' };
  const world = readWorld(unpacked.value);
  return { world, problem: world === null ? 'worldUnknown' : null };
}

type WorldProblem = 'worldDamaged' | 'worldTooLarge' | 'worldUnknown';

/** The files as the link has them, main.py first. */
function filesIn(parameters: Parameters): Pick<ProgramLink, 'files'> | Failed {
  const code = parameters.get('code') === '' ? undefined : parameters.get('code');
  const packed = code === undefined ? parameters.get('fs') : code;
  if (packed === null || packed === undefined) return damaged();
  const unpacked = valueOfPacked(packed, MAX_CHARACTERS);
  if (unpacked === 'too-long') return tooLong(packed.length, MAX_PACKED);
  if (unpacked === 'too-large') return tooLarge(MAX_CHARACTERS);
  if (unpacked === 'damaged') return damaged();
  const files = (code === undefined ? filesOfTree : filesOfList)(unpacked.value);
  if (files !== null) return checked(files);
  return code === undefined
    ? failed('unknown-form', 'The link has its files in a form that we do not know. It is not opened.', {})
    : damaged();
}

/** Read like a project: the same rules judge the files of a link. */
function checked(files: readonly SourceFile[]): Pick<ProgramLink, 'files'> | Failed {
  const parsed = parseProjectValue({
    format: PROJECT_FORMAT,
    version: PROJECT_VERSION,
    files,
    scene: { format: SCENE_FORMAT, version: SCENE_VERSION, ...defaultScene() },
  });
  if (!('problems' in parsed)) return { files: parsed.project.files };
  const what = `The program in the link cannot be opened: ${parsed.problem}`;
  return failed('invalid', what, { max: FILE_BYTES }, parsed.problems);
}

function valueOfPacked(packed: string, maxCharacters: number): { readonly value: unknown } | LzProblem | 'too-long' {
  if (packed.length > MAX_PACKED) return 'too-long';
  const unpacked = textOfLzBase64(packed, maxCharacters);
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
): Failed {
  return { problem: { code, message, params, problems } };
}

const damaged = (): Failed =>
  failed('damaged', 'The link is damaged: a part of it is missing or changed. Copy it again, whole.', {});

const tooLarge = (max: number): Failed =>
  failed('too-large', `The link unpacks to more than ${String(max)} characters. It is not opened.`, { max });

const tooLong = (length: number, max: number): Failed =>
  failed('too-long', `The link has ${String(length)} characters; the limit is ${String(max)}.`, { length, max });
