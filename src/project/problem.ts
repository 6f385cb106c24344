import type { SceneProblem, SceneProblemCode } from '#scene/problem';

/** The codes of faults of a project file. The web translates by this code and the problem's parameters. */
export type ProjectProblemCode =
  | SceneProblemCode
  | 'not-a-project'
  | 'is-a-class'
  | 'not-a-level'
  | 'links-too-large'
  | 'not-beside'
  | 'no-main'
  | 'file-name'
  | 'file-too-large'
  | 'device-name'
  | 'too-many-devices'
  | 'same-as';

/** One thing that is wrong with a project file; the places of its course begin with `scene`. */
export interface ProjectProblem extends Omit<SceneProblem, 'code'> {
  readonly code: ProjectProblemCode;
}
