import { feedbackProject } from '#check/feedback/feedback-project';
import { feedbackLimits } from '#check/feedback/feedback';
import type { WorldResult } from '#check/result';
import type { ClassTask } from '#check/task/task';
import { linkOf } from '#project/link/link';
import type { Project } from '#project/project';

import { readyScene } from '../../../session/work/catalogue/ready-courses';
import type { Row } from '../model/class-model';

/** A feedback as it is given: as a project for a file, and as an address. */
export interface GivenFeedback {
  readonly project: Project;
  /** `null`: it would be too long. */
  readonly link: string | null;
}

/**
 * The feedback on a hand-in, about its run in a world; `null`: the note is too long, there is nothing that could be opened, or the
 * world cannot be made.
 */
export function feedbackOfRow(
  { handIn, result, note, marked }: Row,
  task: ClassTask,
  world: WorldResult,
): GivenFeedback | null {
  if (handIn === null || result === null || note.length > feedbackLimits.noteCharacters) return null;
  const project = feedbackProject({ task, handIn, result, points: marked ?? result.points, note }, world);
  if (project === null) return null;
  const made = linkOf(project, { courses: readyScene, program: true });
  return { project, link: made && `${location.origin}${location.pathname}#${made.fragment}` };
}

/** The world that a feedback is about if nobody chooses: the first that was not passed, else the first. */
export const worldToShow = (worlds: readonly WorldResult[]): WorldResult | null =>
  worlds.find(({ passed }) => !passed) ?? worlds[0] ?? null;

/** The address that brings a pupil the note on a hand-in; `null`: there is no note, or it cannot be had as a link. */
export function noteLink(rows: readonly Row[], task: ClassTask, name: string): string | null {
  const row = rows.find((one) => one.name === name);
  const world = worldToShow(row?.result?.worlds ?? []);
  if (row === undefined || row.note === '' || world === null) return null;
  return feedbackOfRow(row, task, world)?.link ?? null;
}
