import { isRecord } from '#core/record';
import {
  MAIN,
  type FurtherDevice,
  type Project,
  type ProjectDevices,
  type ProjectSettings,
  type SourceFile,
} from '#project/project';
import { parseSceneValue } from '#scene/parse';
import type { Scene, SceneObject } from '#scene/scene';
import { objectText, serializeScene } from '#scene/serialize';

/** A project as text for the browser's storage. It is saved while somebody types, so what has not changed is remembered. */
export const packedText = remembered((project: Project): string => packed(project, sceneText(project.scene)));

/** The same, with the course's text given by the caller. */
export function packed({ files, course, settings, devices }: Project, scene: string): string {
  const rest = JSON.stringify({ course, settings, devices });
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
  const { files, scene, course, settings, devices } = value;
  const parsed = parseSceneValue(scene);
  if (!('scene' in parsed) || !isProgram(files)) return null;
  return {
    files,
    scene: parsed.scene,
    course: typeof course === 'string' ? course : null,
    ...(isSettings(settings) && { settings }),
    ...(isDevices(devices) && { devices }),
  };
}

function isProgram(value: unknown): value is readonly SourceFile[] {
  return Array.isArray(value) && value.every(isFile) && value[0]?.name === MAIN;
}

const isFile = (value: unknown): value is SourceFile =>
  isRecord(value) && typeof value['name'] === 'string' && typeof value['text'] === 'string';

/** Checks the shape of settings that this app itself stored; the names in them are checked when they are used. */
function isSettings(value: unknown): value is ProjectSettings {
  if (!isRecord(value)) return false;
  const { reality, seed, arenaSenses, myRobot } = value;
  return (
    isHardware(value) &&
    typeof reality === 'number' &&
    typeof seed === 'number' &&
    typeof arenaSenses === 'boolean' &&
    (myRobot === undefined || isRecord(myRobot))
  );
}

function isHardware({ device, firmware, robot, robotOptions }: Readonly<Record<string, unknown>>): boolean {
  return (
    [device, firmware, robot].every((id) => typeof id === 'string') &&
    isRecord(robotOptions) &&
    Object.values(robotOptions).every(isRecord)
  );
}

/** Checks the shape of devices in the same way. */
function isDevices(value: unknown): value is ProjectDevices {
  if (!isRecord(value) || typeof value['first'] !== 'string' || !Array.isArray(value['others'])) return false;
  return value['others'].length > 0 && value['others'].every(isFurther);
}

function isFurther(value: unknown): value is FurtherDevice {
  if (!isRecord(value) || !isHardware(value)) return false;
  const { name, files, sameAs } = value;
  if (typeof name !== 'string' || typeof sameAs !== 'string') return false;
  return sameAs === '' ? isProgram(files) : Array.isArray(files) && files.length === 0;
}
