import type { Vec } from '#core/geometry';
import { createCache } from '../../../kit/drawing/shelf';
import type { OverlayPicture } from '../layers/overlays';
import { canvasFont } from '../model/palette';
import { emptyCanvas } from '../robot/robot-sprite';
import type { PxBox } from '../view/moving-window';
import { putPicture } from '../view/whole-pixels';
import { deviceColor } from '#picture/device-colors';

/** A ring around a robot with the number of its device and its name. */
export interface DeviceRing {
  readonly middle: Vec;
  readonly radiusPx: number;
  /** Place of the device. */
  readonly place: number;
  /** Its colour, as `deviceColor` takes it. */
  readonly color: number;
  readonly name: string;
  /** True if the device is shown. */
  readonly isShown: boolean;
}

/** Height of the name and its distance from the ring, in px. */
const NAME_PX = 24;
const GAP_PX = 6;
const FONT = `600 13px ${canvasFont}`;
const NUMBER_FONT = `700 12.5px ${canvasFont}`;

/** On a phone, and where robots are small, the number has to do: names would hide the course. */
const shownName = ({ name, radiusPx }: DeviceRing): string =>
  window.innerWidth < 600 || radiusPx < SMALL_PX ? '' : name;
const SMALL_PX = 16;

/** Place of the name's pill; below the ring at the upper edge of the picture. */
export function nameBox(ring: DeviceRing): PxBox {
  const { middle, radiusPx } = ring;
  const width = pillOf(ring, 1).width;
  const above = middle.y - radiusPx - GAP_PX - NAME_PX;
  const top = above < 0 ? middle.y + radiusPx + GAP_PX : above;
  return { left: middle.x - width / 2, top, width, height: NAME_PX };
}

/** Place of the robot, in px. */
export const bodyBox = ({ middle, radiusPx }: DeviceRing): PxBox => ({
  left: middle.x - radiusPx,
  top: middle.y - radiusPx,
  width: 2 * radiusPx,
  height: 2 * radiusPx,
});

/** The areas in which `drawDeviceRing` draws, in px. */
function ringBoxes(ring: DeviceRing): readonly PxBox[] {
  const { middle, radiusPx } = ring;
  const side = 2 * radiusPx + 8;
  return [{ left: middle.x - side / 2, top: middle.y - side / 2, width: side, height: side }, nameBox(ring)];
}

/** An overlay with a ring below the robot and its name over everything. */
export function withRingAndName(ring: DeviceRing, overlay: OverlayPicture | null): OverlayPicture {
  return {
    boxes: [...ringBoxes(ring), ...(overlay?.boxes ?? [])],
    under(context) {
      overlay?.under(context);
      drawDeviceRing(context, ring);
    },
    over(context) {
      overlay?.over(context);
      drawDeviceName(context, ring);
    },
  };
}

/** The ring, and for the device that is shown a breath of its colour within. */
function drawDeviceRing(context: CanvasRenderingContext2D, ring: DeviceRing): void {
  putPicture(context, ringOf(ring, context.getTransform().a), ring.middle);
}

/** The pill with number and name. */
function drawDeviceName(context: CanvasRenderingContext2D, ring: DeviceRing): void {
  const { left, top, width, height } = nameBox(ring);
  const { bitmap } = pillOf(ring, context.getTransform().a);
  putPicture(context, bitmap, { x: left + width / 2, y: top + height / 2 });
}

/** Eight devices on screens of a few resolutions, under names that change now and then. */
const MOST = 60;
/** Painted once: curves and letters on a canvas of the page cost more than all the rest of a picture. */
const rings = createCache<HTMLCanvasElement>(MOST);
const pills = createCache<Pill>(MOST);

function ringOf(ring: DeviceRing, ratio: number): HTMLCanvasElement {
  const { color, radiusPx, isShown } = ring;
  return rings([color, radiusPx, isShown, ratio], () => paintedRing(ring, ratio));
}

function paintedRing({ radiusPx, color, isShown }: DeviceRing, ratio: number): HTMLCanvasElement {
  const side = 2 * Math.ceil((radiusPx + 4) * ratio);
  const bitmap = emptyCanvas(side, side);
  const context = bitmap.getContext('2d');
  if (context === null) return bitmap;
  context.setTransform(ratio, 0, 0, ratio, side / 2, side / 2);
  context.arc(0, 0, radiusPx, 0, 2 * Math.PI);
  if (isShown) {
    context.globalAlpha = 0.1;
    context.fillStyle = deviceColor(color);
    context.fill();
    context.globalAlpha = 1;
  }
  context.strokeStyle = '#ffffff';
  context.lineWidth = 5.5;
  context.stroke();
  context.strokeStyle = deviceColor(color);
  context.lineWidth = 2.5;
  context.stroke();
  return bitmap;
}

interface Pill {
  readonly bitmap: HTMLCanvasElement;
  /** CSS px. */
  readonly width: number;
}

function pillOf(ring: DeviceRing, ratio: number): Pill {
  const { place, color } = ring;
  const text = shownName(ring);
  return pills([place, color, ratio, text], () => painted({ place, color }, text, ratio));
}

function painted({ place, color }: Pick<DeviceRing, 'place' | 'color'>, text: string, ratio: number): Pill {
  const bitmap = document.createElement('canvas');
  const ruler = document.createElement('canvas').getContext('2d');
  if (ruler !== null) ruler.font = FONT;
  const width = text === '' ? NAME_PX : Math.ceil(ruler?.measureText(text).width ?? 0) + NAME_PX + 14;
  bitmap.width = Math.ceil(width * ratio);
  bitmap.height = Math.ceil(NAME_PX * ratio);
  const context = bitmap.getContext('2d');
  if (context === null) return { bitmap, width };
  const middle = NAME_PX / 2;
  context.scale(bitmap.width / width, bitmap.height / NAME_PX);
  context.textBaseline = 'middle';
  context.fillStyle = deviceColor(color);
  context.beginPath();
  context.roundRect(0, 0, width, NAME_PX, middle);
  context.fill();
  context.fillStyle = '#ffffff';
  context.beginPath();
  context.arc(middle, middle, middle - 2.5, 0, 2 * Math.PI);
  context.fill();
  context.font = FONT;
  context.fillText(text, NAME_PX + 4, middle + 1);
  context.font = NUMBER_FONT;
  context.fillStyle = deviceColor(color);
  context.textAlign = 'center';
  context.fillText(String(place + 1), middle, middle + 1);
  return { bitmap, width };
}
