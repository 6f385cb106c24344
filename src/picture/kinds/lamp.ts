import { mdiLightbulbOffOutline, mdiLightbulbOnOutline } from '@mdi/js';
import type { Vec } from '#core/geometry';
import { beginsOn } from '#scene/kinds/switching';
import { heightOf, isStanding } from '#scene/kinds/heights';
import { solidParts } from '#scene/kinds/index';
import { LAMP_MM } from '#scene/kinds/lamp';
import { convexHull, lengthOf } from '#scene/outline';
import type { Lamp, LampColor, Point, SceneObject } from '#scene/scene';

import type { Look } from '../look';
import { circle, group, rect, written, type Shape } from '../shapes';
import { icon } from './block';
import type { PictureKind } from './kind';

/** Lamps: a disc with its sign and the light below it, a glow that fades, and the shadows of what never moves. */
export const lamp: PictureKind<Lamp> = {
  mark: (lamp, look, around = []) =>
    look.isLit === true && isShining(lamp) ? [...glow(lamp), ...shadows(lamp, around)] : [],
  body: (lamp, look) => [group(lamp.at, disc(lamp, look))],
  paper: ({ at }) => [circle(LAMP_MM / 2, { stroke: '#000000', width: 1 }, at)],
  frame: ({ at: [x, y] }) => ({ at: { x, y }, angleRad: 0, size: { x: LAMP_MM, y: LAMP_MM } }),
};

/** An object that is shown as a run has it: a lamp that shines or not, a barrier that is open or not. */
export interface Switched {
  readonly isOn?: boolean;
}

const isShining = (lamp: Lamp & Switched): boolean => lamp.isOn ?? beginsOn(lamp.on ?? null);

/** Glow and disc by colour; `warm` is the usual white. */
const LIGHTS: Readonly<Record<LampColor | 'warm', { readonly glow: string; readonly disc: string }>> = {
  warm: { glow: '#FFC533', disc: '#FFEDB3' },
  yellow: { glow: '#F2C200', disc: '#FFE36B' },
  red: { glow: '#F0444A', disc: '#FFB3B5' },
  green: { glow: '#2FB86A', disc: '#A9EBC4' },
  blue: { glow: '#3D86F0', disc: '#B5D3FF' },
};
const OFF = '#DDE1E6';
const INK = '#3D2E00';

/** Height of the sensors' eyes above the floor: shadows are drawn as they see them. */
const EYE_MM = 60;

/** How far the glow of a lamp is drawn, in mm. Chosen by eye: of an LED torch about half a metre. */
const reachMm = ({ brightness }: Lamp): number => Math.max(120, Math.min(1500, 85 * Math.sqrt(brightness)));

const RINGS = 24;

/** Rings of thin light, one over the other, so that it is bright in the middle. */
function glow(lamp: Lamp): readonly Shape[] {
  const fill = LIGHTS[lamp.color ?? 'warm'].glow;
  return Array.from({ length: RINGS }, (_, ring) => {
    const share = (RINGS - ring) / RINGS;
    return circle(reachMm(lamp) * share * Math.sqrt(share), { fill, opacity: 0.026 }, lamp.at);
  });
}

const SLICES = 7;

/** The shadows of walls and other things that never move, each darkest at the thing's edge. */
function shadows(lamp: Lamp, around: readonly SceneObject[]): readonly Shape[] {
  return around.flatMap((object) => {
    if (!isStanding(object) || object.type === 'block' || object.type === 'mover') return [];
    if (object.type === 'barrier' && (object as Switched).isOn === true) return [];
    const heightMm = heightOf(object);
    return heightMm <= EYE_MM ? [] : solidParts(object).flatMap((part) => shadowOf(lamp, part, heightMm));
  });
}

function shadowOf(lamp: Lamp, part: readonly Vec[], heightMm: number): readonly Shape[] {
  const [x, y] = lamp.at;
  const away = Math.min(...part.map((corner) => lengthOf(corner.x - x, corner.y - y)));
  const end = heightMm < lamp.height ? (lamp.height - EYE_MM) / (lamp.height - heightMm) : Infinity;
  const farthest = Math.min(end, (1.1 * reachMm(lamp)) / Math.max(away, 5));
  if (farthest <= 1) return [];
  return Array.from({ length: SLICES }, (_, slice): Shape => {
    const times = 1 + ((farthest - 1) * (slice + 1)) / SLICES;
    const far = part.map((corner) => ({ x: x + (corner.x - x) * times, y: y + (corner.y - y) * times }));
    const outline = convexHull([...part, ...far]).map((corner): Point => [corner.x, corner.y]);
    return { form: 'lines', lines: [outline], isClosed: true, fill: '#2B2F36', opacity: 0.05 };
  });
}

/** The light right below a lamp in words, to two digits. */
export function lightBelow({ brightness, height }: Lamp): string {
  const metres = (height - EYE_MM) / 1000;
  const lux = brightness / (metres * metres);
  const digit = lux >= 1000 ? 100 : lux >= 100 ? 10 : 1;
  return `${String(Math.round(lux / digit) * digit)} lx`;
}

function disc(lamp: Lamp, look: Look): readonly Shape[] {
  const isOn = isShining(lamp);
  const radius = LAMP_MM / 2;
  const light = lightBelow(lamp);
  const size = LAMP_MM * 0.38;
  const wide = size * (0.62 * light.length + 0.9);
  return [
    circle(radius - 1.2, { fill: isOn ? LIGHTS[lamp.color ?? 'warm'].disc : OFF }),
    circle(radius - 1.2, { stroke: INK, width: Math.max(2, look.px) }),
    ...icon(isOn ? mdiLightbulbOnOutline : mdiLightbulbOffOutline, LAMP_MM * 0.66, INK, look),
    ...(size < 6 * look.px
      ? []
      : [
          group(
            [radius + 8 + wide / 2, 0],
            [rect([wide, size * 1.7], size * 0.85, { fill: '#1B1F24' }), written(light, size, '#FFFFFF')],
          ),
        ]),
  ];
}
