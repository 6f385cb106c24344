import { isRecord } from '#core/record';
import { MAIN, type Project, type ProjectSettings, type SourceFile } from '#project/project';
import { parseSceneValue } from '#scene/parse';
import type { Scene, SceneObject } from '#scene/scene';
import { objectText, serializeScene } from '#scene/serialize';

/** A project as text for the browser's storage. It is saved while somebody types, so what has not changed is remembered. */
export const packedText = remembered((project: Project): string => packed(project, sceneText(project.scene)));

/** The same, with the course's text given by the caller. */
export function packed({ files, course, settings }: Project, scene: string): string {
  const rest = JSON.stringify({ course, settings });
  return `{"files":${JSON.stringify(files)},"scene":${scene},${rest.slice(1)}`;
}

/** The course as text. Each object is written once: a course may have 20,000 points, and a stroke of the pen adds one object. */
export const sceneText = remembered((scene: Scene): string => {
  const bare = compact(serializeScene({ ...scene, objects: [] }));
  return `${bare.slice(0, -'[]}'.length)}[${scene.objects.map(compactObject).join(',')}]}`;
});

const compactObject = remembered((object: SceneObject): string => compact(objectText(object)));

const compact = (text: string): string => JSON.stringify(JSON.parse(text));

/** Texts of things that never change, as long as the things are there. */
function remembered<T extends object>(write: (of: T) => string): (of: T) => string {
  const texts = new WeakMap<T, string>();
  return (of) => {
    const known = texts.get(of);
    if (known !== undefined) return known;
    const text = write(of);
    texts.set(of, text);
    return text;
  };
}

/** Reads what `packedText` made; `null` for anything else. */
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

/** Checks the shape of settings that this app itself stored; the names in them are checked when they are used. */
function isSettings(value: unknown): value is ProjectSettings {
  if (!isRecord(value)) return false;
  const { device, firmware, robot, robotOptions, reality, seed, arenaSenses, myRobot } = value;
  return (
    [device, firmware, robot].every((id) => typeof id === 'string') &&
    isRecord(robotOptions) &&
    Object.values(robotOptions).every(isRecord) &&
    typeof reality === 'number' &&
    typeof seed === 'number' &&
    typeof arenaSenses === 'boolean' &&
    (myRobot === undefined || isRecord(myRobot))
  );
}
