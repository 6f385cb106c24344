import { MAIN, type Project } from '#project/project';

/** The first device's `main.py`, in which lines are locked. */
export const mainText = ({ files }: Pick<Project, 'files'>): string =>
  files.find(({ name }) => name === MAIN)?.text ?? '';
