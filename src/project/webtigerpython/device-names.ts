/** WebTigerPython's names for the microcomputers that we have, and our ids. `-` is its name for none: ours is chosen as usual. */
const DEVICES: Readonly<Record<string, string>> = {
  'micro:bit': 'microbit-v2',
  'Calliope mini 1/2': 'calliope-mini-2',
  'Calliope mini 3': 'calliope-mini-3',
  '-': 'auto',
};

/** Id of the microcomputer that WebTigerPython calls like this; `null`: one that we do not have. */
export const deviceCalled = (name: string): string | null => (Object.hasOwn(DEVICES, name) && DEVICES[name]) || null;
