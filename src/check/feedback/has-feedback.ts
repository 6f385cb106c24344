import type { Project } from '#project/project';

/** The name of a feedback among what belongs to handing in. */
export const FEEDBACK = 'feedback';

/** True if a project brings a feedback, whether it can be read or not. */
export const hasFeedback = ({ handIn }: Pick<Project, 'handIn'>): boolean => handIn?.[FEEDBACK] !== undefined;
