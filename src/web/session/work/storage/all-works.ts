import type { Project } from '#project/project';

import type { Previous } from './history';
import { packedText } from './stored-project';

/**
 * The earlier works with those of other tabs, newest first, each once.
 *
 * @param besides what is open, and what was deleted: they are never among them
 */
export function withAll(
  previous: readonly Previous[],
  works: readonly Previous[],
  besides: readonly Project[],
): readonly Previous[] {
  const known = new Set([...besides, ...previous.map(({ project }) => project)].map(written));
  const others = works.filter(({ project }) => {
    const isNew = !known.has(written(project));
    known.add(written(project));
    return isNew;
  });
  if (others.length === 0) return previous;
  return [...previous, ...others].sort((one, other) => other.atMs - one.atMs);
}

/** The text of everything that was written and built, whatever hardware it is for. */
const written = ({ files, scene, devices, task }: Project): string =>
  packedText({ files, scene, course: null, ...(devices && { devices }), ...(task && { task }) });
