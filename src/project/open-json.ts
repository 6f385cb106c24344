import { parseSceneValue } from '#scene/parse';
import { SCENE_FORMAT, type Scene } from '#scene/scene';
import type { SceneProblem } from '#scene/problem';

import { looksLikeEarlierLevel, sceneOfEarlierLevel } from './earlier-levels';
import { formatOf, isProjectFile, parseProject, parseProjectValue } from './file';
import type { ProjectProblem } from './problem';
import { projectLimits, type Project } from './project';

/** The result of opening a JSON file. */
export type OpenedFile =
  | { readonly kind: 'project'; readonly project: Project }
  | { readonly kind: 'scene'; readonly scene: Scene }
  | {
      readonly kind: 'problem';
      readonly problem: string;
      readonly problems: readonly (ProjectProblem | SceneProblem)[];
    };

/** Reads a JSON file of any known kind: a project, a course, or a level of an earlier simulator. Never throws. */
export function openJson(text: string): OpenedFile {
  const value = valueOf(text);
  // A text that is not JSON, or far too long, gets the messages of a project file.
  if (value === undefined || isProjectFile(value)) return projectFile(value, text);
  const format = formatOf(value);
  if (format !== SCENE_FORMAT && looksLikeEarlierLevel(value)) {
    const level = sceneOfEarlierLevel(value);
    if ('scene' in level) return { kind: 'scene', scene: level.scene };
    const { problem, place } = level;
    const params = {};
    return problemOf(problem, [{ code: 'not-a-level', path: place, value: '', params, message: problem }]);
  }
  if (format !== SCENE_FORMAT) {
    const message = 'This is neither a project nor a course: "format" is missing or unknown.';
    return problemOf(message, [{ code: 'not-a-project', path: 'format', value: '', params: {}, message }]);
  }
  const parsed = parseSceneValue(value);
  return 'scene' in parsed ? { kind: 'scene', scene: parsed.scene } : problemOf(parsed.problem, parsed.problems);
}

function projectFile(value: unknown, text: string): OpenedFile {
  const parsed = value === undefined ? parseProject(text) : parseProjectValue(value);
  return 'project' in parsed
    ? { kind: 'project', project: parsed.project }
    : problemOf(parsed.problem, parsed.problems);
}

const problemOf = (problem: string, problems: readonly (ProjectProblem | SceneProblem)[]): OpenedFile => ({
  kind: 'problem',
  problem,
  problems,
});

/** The JSON value of a text; `undefined`: none, or longer than any file of ours. */
function valueOf(text: string): unknown {
  if (text.length > projectLimits.textCharacters) return undefined;
  try {
    return JSON.parse(text.startsWith('\ufeff') ? text.slice(1) : text);
  } catch {
    return undefined;
  }
}
