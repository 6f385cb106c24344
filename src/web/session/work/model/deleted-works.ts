import { DELETED_MS, type Deleted, type Previous, type Work } from '../storage/history';

/** The work without earlier ones that were just deleted; what was deleted long ago is forgotten. */
export function withDeleted(
  work: Work,
  entries: readonly Previous[],
  deleted: readonly Deleted[],
  nowMs: number,
): Work {
  const still = (work.deleted ?? []).filter(({ deletedMs }) => nowMs - deletedMs < DELETED_MS);
  return {
    ...work,
    previous: work.previous.filter((entry) => !entries.includes(entry)),
    deleted: [...deleted, ...still],
  };
}

/** The work with deleted ones back in their places, as far as they are still there. */
export function withoutDeleted(work: Work, back: readonly Deleted[]): Work {
  const { deleted = [], ...others } = work;
  const found = deleted.filter((entry) => back.includes(entry));
  const entries = found.map(({ deletedMs: _, ...entry }): Previous => entry);
  const rest = deleted.filter((entry) => !found.includes(entry));
  const previous = [...others.previous, ...entries].sort((one, other) => other.atMs - one.atMs);
  return { ...others, previous, ...(rest.length > 0 && { deleted: rest }) };
}
