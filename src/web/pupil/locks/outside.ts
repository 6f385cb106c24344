import { HAND_IN_VERSION, type SaidRemark } from '#check/hand-in/hand-in';
import type { Project } from '#project/project';

const OUTSIDE: SaidRemark = 'outside';

const remarksIn = ({ handIn }: Project): readonly unknown[] => {
  const remarks = handIn?.['remarks'];
  return Array.isArray(remarks) ? (remarks as readonly unknown[]) : [];
};

/** True if some of the program was written elsewhere. */
export const isFromOutside = (project: Project): boolean => remarksIn(project).includes(OUTSIDE);

/**
 * The project with the remark that some of its program was written elsewhere. The remark stays with the work, over a
 * reload and in its file.
 */
export function withOutsideRemark(project: Project): Project {
  if (isFromOutside(project)) return project;
  const remarks = [...remarksIn(project), OUTSIDE];
  return { ...project, handIn: { version: HAND_IN_VERSION, ...project.handIn, remarks } };
}

/** Whether files come with a text that was in none before: not by renaming, removing, or making an empty one. */
export function bringsText({ files: before }: Project, { files: after }: Project): boolean {
  const known = new Set(before.map(({ text }) => text));
  return after.some(({ text }) => text.trim() !== '' && !known.has(text));
}
