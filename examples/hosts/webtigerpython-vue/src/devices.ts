import { createParcoursDevice, type DeviceInterface, type DeviceState } from 'parcours-webtigerpython';

/** What a device may use of the page. */
export interface Surroundings {
  /** The pane in which it shows itself. */
  readonly canvas: HTMLElement;
  readonly print: (text: string) => void;
  readonly fail: (text: string) => void;
  readonly tell: (state: DeviceState) => void;
}

/** An entry of the device menu. */
export interface DeviceEntry {
  readonly name: string;
  readonly create: (page: Surroundings) => DeviceInterface | null;
}

/** Where Parcours is served; `?parcours=…` of the page says otherwise. */
const PARCOURS = new URLSearchParams(location.search).get('parcours') ?? 'http://localhost:8080/';

const parcours =
  (board: string, robot: string) =>
  ({ canvas, print, fail, tell }: Surroundings): DeviceInterface =>
    createParcoursDevice({
      container: canvas,
      address: PARCOURS,
      title: 'Simulator',
      board,
      robot,
      parts: robot === 'none' ? ['board'] : ['arena'],
      language: 'en',
      theme: 'light',
      onOutput: print,
      onError: fail,
      onState: tell,
    });

/** The device menu. Another kind of device is another entry. */
export const devices: readonly DeviceEntry[] = [
  { name: '-', create: () => null },
  { name: 'micro:bit', create: parcours('microbit-v2', 'none') },
  { name: 'Calliope mini 3', create: parcours('calliope-mini-3', 'none') },
  { name: 'Robot', create: parcours('auto', 'auto') },
];
