import { fnvOfText } from '#core/fnv';
import { isRecord } from '#core/record';

import { editProblem, parseEdit } from './check-edit';
import { applyEdit, type SceneEdit } from './edit';
import { editBetween } from './edit-between';
import { historyOf, type History } from './history';
import type { Scene } from './scene';
import { serializeScene } from './serialize';

/** The version of the text; another one is not read. */
const VERSION = 1;

/** Steps that are kept each way. Chosen: what somebody wants back after a page was loaded anew. */
const KEPT_STEPS = 100;

/**
 * The way of a course as text: the edits that lead back from it, and those that lead forth again. The course itself is not
 * in it, only what tells it from others.
 *
 * @param maxCharacters the furthest steps are left out where there are more
 */
export function historyToText({ past, present, future }: History, maxCharacters: number): string {
  const half = Math.floor(maxCharacters / 2);
  const back = edits(present, [...past].reverse(), half);
  const forth = edits(present, future, half);
  return `{"version":${String(VERSION)},"of":${JSON.stringify(markOf(present))},"back":[${back.join(',')}],"forth":[${forth.join(',')}]}`;
}

function edits(from: Scene, to: readonly Scene[], maxCharacters: number): readonly string[] {
  const texts: string[] = [];
  let before = from;
  let characters = 0;
  for (const after of to.slice(0, KEPT_STEPS)) {
    const text = JSON.stringify(editBetween(before, after) ?? NOTHING);
    characters += text.length;
    if (characters > maxCharacters) break;
    texts.push(text);
    before = after;
  }
  return texts;
}

const NOTHING: SceneEdit = { type: 'all', edits: [] };

/**
 * The way of a course as `historyToText` wrote it. Never throws: of a text that is damaged, or belongs to another course,
 * comes what can be used, or nothing.
 */
export function historyFromText(text: string, present: Scene): History {
  const none = historyOf(present);
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return none;
  }
  if (!isRecord(value) || value['version'] !== VERSION || value['of'] !== markOf(present)) return none;
  return { past: [...scenes(present, value['back'])].reverse(), present, future: scenes(present, value['forth']) };
}

function scenes(from: Scene, list: unknown): readonly Scene[] {
  const found: Scene[] = [];
  let scene = from;
  for (const value of Array.isArray(list) ? list.slice(0, KEPT_STEPS) : []) {
    const parsed = parseEdit(value);
    if (!('edit' in parsed) || editProblem(scene, parsed.edit) !== null) break;
    scene = applyEdit(scene, parsed.edit);
    found.push(scene);
  }
  return found;
}

/** Tells courses apart by chance: the length of the file and a checksum of it. */
function markOf(scene: Scene): string {
  const text = serializeScene(scene);
  return `${String(text.length)}/${String(fnvOfText(text))}`;
}
