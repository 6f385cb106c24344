/** WebTigerPython's names for our microcomputers, and our ids. Its name `-` means none: ours is chosen as usual. */
const DEVICES: Readonly<Record<string, string>> = {
  'micro:bit': 'microbit-v2',
  'Calliope mini 1/2': 'calliope-mini-2',
  'Calliope mini 3': 'calliope-mini-3',
  '-': 'auto',
};

/** Id of the microcomputer with this name in WebTigerPython; `null` for one that we do not have. */
export const deviceCalled = (name: string): string | null => (Object.hasOwn(DEVICES, name) && DEVICES[name]) || null;

/** WebTigerPython's name of the microcomputer with this id; `null` for one that it does not have. */
export const deviceNameOf = (id: string): string | null =>
  Object.entries(DEVICES).find(([, own]) => own === id)?.[0] ?? null;

/** The modules of the robots that its simulator has: a program's imports choose one. */
const ROBOT_MODULES: readonly string[] = ['mbrobot', 'mbrobot_plusV2', 'mbrobot_plusV3', 'callibot'];

/** True if its simulator has the robot of one of these modules. */
export const hasRobotOf = (modules: readonly string[]): boolean =>
  modules.some((module) => ROBOT_MODULES.includes(module));
