import { isRecord } from '#core/record';
import { MAIN, type Project, type ProjectSettings, type SourceFile } from '#project/project';
import { parseSceneValue } from '#scene/parse';
import { serializeScene } from '#scene/serialize';

/** A project as plain data for the browser's storage. */
export function packProject(project: Project): unknown {
  const scene: unknown = JSON.parse(serializeScene(project.scene));
  const { files, course, settings } = project;
  return { files, scene, course, ...(settings === undefined ? {} : { settings }) };
}

/** The same as text. The last ones are remembered: a project never changes, and an arena may be large. */
export function packedText(project: Project): string {
  const known = texts.get(project);
  if (known !== undefined) return known;
  const text = JSON.stringify(packProject(project));
  texts.set(project, text);
  return text;
}
const texts = new WeakMap<Project, string>();

/** Reads what `packProject` made; `null` for anything else. */
export function unpackProject(value: unknown): Project | null {
  if (!isRecord(value)) return null;
  const { files, scene, course, settings } = value;
  if (!Array.isArray(files)) return null;
  const read = files.map(readFile);
  const parsed = parseSceneValue(scene);
  if (!('scene' in parsed) || read[0]?.name !== MAIN || read.includes(null)) return null;
  const project: Project = {
    files: read.filter((file) => file !== null),
    scene: parsed.scene,
    course: typeof course === 'string' ? course : null,
  };
  return isSettings(settings) ? { ...project, settings } : project;
}

function readFile(value: unknown): SourceFile | null {
  if (!isRecord(value)) return null;
  const { name, text } = value;
  return typeof name === 'string' && typeof text === 'string' ? { name, text } : null;
}

/** What this app itself stored: what the settings name is looked at when they are used. */
function isSettings(value: unknown): value is ProjectSettings {
  if (!isRecord(value)) return false;
  const { device, firmware, robot, robotOptions, reality, seed, arenaSenses } = value;
  return (
    [device, firmware, robot].every((id) => typeof id === 'string') &&
    isRecord(robotOptions) &&
    Object.values(robotOptions).every(isRecord) &&
    typeof reality === 'number' &&
    typeof seed === 'number' &&
    typeof arenaSenses === 'boolean'
  );
}
