/**
 * Stores large parts of the work apart from it. The browser's storage for text holds about five million characters for
 * all tabs together, and a picture as floor has up to 1.5 million: such parts, and large earlier work, go to the store
 * for pieces (`piece-store.ts`), and the work names them. A piece never changes: its name is made from its content.
 */
import type { Project } from '#project/project';
import type { Background } from '#scene/scene';

import { memoOf } from '#core/memo';
import { textOfWork, type Previous, type Work } from './history';
import { packed, packedText, sceneText } from './stored-project';

/** The name of a piece: `{ "parcours.piece": name }` stands in its place. */
const KEY = 'parcours.piece';

/**
 * Parts shorter than this (characters) stay with the work. Chosen: five earlier projects of this size take little room.
 */
const PIECE_CHARACTERS = 20_000;

/** Number of the newest works for which this holds; every work before them may lie apart, whatever its size. */
const WITH_THE_WORK = 5;

/** A part of the work that may be stored apart. */
export interface Piece {
  readonly name: string;
  readonly text: string;
}

/**
 * Work as text, its large parts by name.
 *
 * @param isKept whether a piece may be named: it is in its store; others stay where they are
 * @returns the text, and the pieces that are still in it
 */
export function splitWork(work: Work, isKept: (name: string) => boolean): { text: string; loose: readonly Piece[] } {
  const loose = new Map<string, Piece>();
  /** The piece's reference if it is in its store, else the text itself. */
  function standIn(piece: Piece | null, text: string): string {
    if (piece === null) return text;
    if (isKept(piece.name)) return reference(piece);
    loose.set(piece.name, piece);
    return text;
  }
  function projectText(project: Project): string {
    const { background } = project.scene;
    const piece = background === null ? null : backgroundPiece(background);
    if (piece === null || standIn(piece, '') === '') return packedText(project);
    const bare = sceneText({ ...project.scene, background: null });
    return packed(project, `{"background":${reference(piece)},${bare.slice(1)}`);
  }
  const near = new Set<Previous>(work.previous.slice(0, WITH_THE_WORK));
  const text = textOfWork(work, projectText(work.project), (entry) => {
    const { project } = entry;
    return standIn(near.has(entry) ? largePiece(project) : projectPiece(project), packedText(project));
  });
  return { text, loose: [...loose.values()] };
}

const reference = ({ name }: Piece): string => JSON.stringify({ [KEY]: name });

/** Stored work with its pieces where they belong. A missing floor is left out, and so is earlier work that is missing. */
export function joinWork(text: string, pieces: ReadonlyMap<string, string>): string {
  const value: unknown = JSON.parse(text, (_, part: unknown) => {
    const name = nameIn(part);
    return name === null ? part : (JSON.parse(pieces.get(name) ?? 'null') as unknown);
  });
  return JSON.stringify(value);
}

/** The names of the pieces in stored work; most work has none. */
export function piecesIn(text: string): readonly string[] {
  const names: string[] = [];
  // In a text of the pupil the quotes would have backslashes before them.
  for (const [, name] of text.matchAll(/"parcours\.piece":"([\w-]+)"/g)) if (name !== undefined) names.push(name);
  return names;
}

function nameIn(part: unknown): string | null {
  if (typeof part !== 'object' || part === null || !(KEY in part)) return null;
  return typeof part[KEY] === 'string' ? part[KEY] : null;
}

const backgroundPiece = memoOf((background: Background): Piece | null => {
  const isLarge = background.levels.length + background.picture.length >= PIECE_CHARACTERS;
  return isLarge ? pieceOf(JSON.stringify(background)) : null;
});

const projectPiece = memoOf((project: Project): Piece => pieceOf(packedText(project)));

const largePiece = (project: Project): Piece | null =>
  packedText(project).length >= PIECE_CHARACTERS ? projectPiece(project) : null;

/** A piece, named by two FNV-1a sums and the length of its text: no two pieces of one pupil have the same name. */
function pieceOf(text: string): Piece {
  let one = 0x811c9dc5;
  let other = 0x01234567;
  for (let index = 0; index < text.length; index += 1) {
    const unit = text.charCodeAt(index);
    one = Math.imul(one ^ unit, 0x01000193);
    other = Math.imul(other ^ unit, 0x01000193) + 0x9e3779b9;
  }
  const name = [text.length, one >>> 0, other >>> 0].map((part) => part.toString(36)).join('-');
  return { name, text };
}
