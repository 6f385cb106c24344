import { fnvOfText } from '#core/fnv';
import { isRecord } from '#core/record';

import { editProblem, parseEdit } from './check-edit';
import { applyEdit, type SceneEdit } from './edit';
import { historyOf, stepOf, type History, type Step } from './history';
import type { Scene } from './scene';
import { serializeScene } from './serialize';

/** The version of the text; another one is not read. */
const VERSION = 1;

/** Steps that are kept each way. Chosen: what somebody wants back after a page was loaded anew. */
const KEPT_STEPS = 100;

/**
 * The history of a course as text: the edits that lead back from it, and those that lead forth again. Of the course
 * itself it holds only the length and a checksum of its file.
 *
 * @param maxCharacters maximum length of all edits, half of it each way; the furthest steps are left out
 */
export function historyToText({ past, present, future }: History, maxCharacters: number): string {
  const half = Math.floor(maxCharacters / 2);
  const back = texts(past.slice(-KEPT_STEPS).reverse(), ({ inverse }) => inverse, half);
  const forth = texts(future.slice(0, KEPT_STEPS), ({ edit }) => edit, half);
  return `{"version":${String(VERSION)},"of":${JSON.stringify(markOf(present))},"back":[${back.join(',')}],"forth":[${forth.join(',')}]}`;
}

function texts(steps: readonly Step[], editOf: (step: Step) => SceneEdit, maxCharacters: number): readonly string[] {
  const found: string[] = [];
  let characters = 0;
  for (const step of steps) {
    const text = JSON.stringify(editOf(step));
    characters += text.length;
    if (characters > maxCharacters) break;
    found.push(text);
  }
  return found;
}

/**
 * The history of a course as `historyToText` wrote it. Never throws: the text of another course, or one that is not
 * JSON, gives an empty history; each way ends before the first edit that does not suit the course.
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
  const back = steps(present, value['back']);
  const past = back.map((step): Step => ({ ...step, edit: step.inverse, inverse: step.edit })).reverse();
  return { past, present, future: steps(present, value['forth']) };
}

/** The edits of a list as steps, each from where the one before leads. */
function steps(from: Scene, list: unknown): readonly Step[] {
  const found: Step[] = [];
  let scene = from;
  for (const value of Array.isArray(list) ? list.slice(0, KEPT_STEPS) : []) {
    const parsed = parseEdit(value);
    if (!('edit' in parsed) || editProblem(scene, parsed.edit) !== null) break;
    found.push(stepOf(scene, parsed.edit));
    scene = applyEdit(scene, parsed.edit);
  }
  return found;
}

/** A mark that two courses hardly ever share: the length of the file and a checksum of it. */
function markOf(scene: Scene): string {
  const text = serializeScene(scene);
  return `${String(text.length)}/${String(fnvOfText(text))}`;
}
