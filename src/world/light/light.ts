import type { Vec } from '#core/geometry';
import type { Stop } from '#core/stop';
import type { Obstacle } from '../probes/distance-cone';
import { isInShadow } from './shadow';

/** Height of every eye for light above the floor, in mm. Chosen: a board that lies on a robot, and sensors on its front. */
export const EYE_MM = 60;

/** Light of an ordinary classroom, in lx (300 … 500: docs/hardware/light.md). */
export const ROOM_LX = 300;

/** Light inside a tunnel, from nowhere: a closed shoe box with two open ends has 1 … 5 lx. */
const TUNNEL_LX = 2;

/** A lamp: a point that shines the same in all directions. */
export interface LampShape {
  readonly atMm: Vec;
  /** Above the floor. */
  readonly heightMm: number;
  /** In cd, which are lx at a metre. */
  readonly candela: number;
  readonly on: boolean;
}

/** A lamp in the world. */
export interface LampHandle {
  switch(on: boolean): void;
  readonly remove: Stop;
}

/** A small flat eye for light, `EYE_MM` above the floor. */
export interface Eye {
  readonly atMm: Vec;
  /** The direction to which it is turned, z up; its length is 1. */
  readonly facing: Facing;
}

/** A direction in space, z up; its length is 1. */
export interface Facing {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/** Straight up, like the display of a board that lies on a robot. */
export const UPWARDS: Facing = { x: 0, y: 0, z: 1 };

/** The light in an arena: of the room, from all sides, and of lamps, behind which things throw shadows. */
export interface Light {
  /** The light of the room, in lx; by itself `ROOM_LX`. */
  setRoom(lx: number): void;
  addLamp(lamp: LampShape): LampHandle;
  /** Darkens a part of the floor: convex outlines in world mm. Only lamps in the same tunnel reach what is inside. */
  addTunnel(partsMm: readonly (readonly Vec[])[]): Stop;
  /** True once there is a lamp or a tunnel, or the room has another light than usual. */
  readonly isKnown: boolean;
  /**
   * The light that an eye receives, in lx: I · cos φ / d² of each lamp whose ray to the eye nothing cuts, and the room's.
   *
   * @param obstacles everything that may throw a shadow; asked for only where a lamp is on
   */
  at(eye: Eye, obstacles: () => Iterable<Obstacle>): number;
}

type Tunnel = readonly (readonly Vec[])[];

/** Makes the light of an ordinary room without lamps. */
export function createLight(): Light {
  const lamps = new Map<LampHandle, LampShape>();
  const tunnels = new Set<Tunnel>();
  let roomLx = ROOM_LX;
  let isKnown = false;

  const tunnelAt = (place: Vec): Tunnel | null => {
    for (const tunnel of tunnels) if (tunnel.some((part) => holds(part, place))) return tunnel;
    return null;
  };

  return {
    setRoom(lx) {
      roomLx = lx;
      isKnown ||= lx !== ROOM_LX;
    },
    addLamp(shape) {
      const handle: LampHandle = {
        switch: (on) => {
          if (lamps.has(handle)) lamps.set(handle, { ...shape, on });
        },
        remove: () => void lamps.delete(handle),
      };
      lamps.set(handle, shape);
      isKnown = true;
      return handle;
    },
    addTunnel(partsMm) {
      tunnels.add(partsMm);
      isKnown = true;
      return () => void tunnels.delete(partsMm);
    },
    get isKnown() {
      return isKnown;
    },
    at(eye, obstacles) {
      const around = tunnels.size === 0 ? null : tunnelAt(eye.atMm);
      let lx = around === null ? roomLx : Math.min(roomLx, TUNNEL_LX);
      let things: readonly Obstacle[] | null = null;
      for (const lamp of lamps.values()) {
        if (!lamp.on || (tunnels.size > 0 && tunnelAt(lamp.atMm) !== around)) continue;
        const received = lightOf(lamp, eye);
        if (received === 0) continue;
        things ??= [...obstacles()].filter(({ heightMm }) => heightMm > EYE_MM);
        const ray = { fromMm: lamp.atMm, toMm: eye.atMm, fromHeightMm: lamp.heightMm, toHeightMm: EYE_MM };
        if (!things.some((thing) => isInShadow(ray, thing))) lx += received;
      }
      return lx;
    },
  };
}

/** The light of a lamp at an eye that nothing shades, in lx; 0 from behind the eye. */
function lightOf({ atMm, heightMm, candela }: LampShape, { atMm: eyeMm, facing }: Eye): number {
  const x = (atMm.x - eyeMm.x) / 1000;
  const y = (atMm.y - eyeMm.y) / 1000;
  const z = (heightMm - EYE_MM) / 1000;
  const squaredM2 = x * x + y * y + z * z;
  const along = x * facing.x + y * facing.y + z * facing.z;
  return along > 0 ? (candela * along) / (squaredM2 * Math.sqrt(squaredM2)) : 0;
}

/** True if a place lies within a convex outline, whichever way round it goes. */
function holds(outline: readonly Vec[], { x, y }: Vec): boolean {
  let [lefts, rights] = [0, 0];
  let from = outline[outline.length - 1] ?? { x, y };
  for (const to of outline) {
    const side = (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
    if (side > 0) lefts++;
    if (side < 0) rights++;
    from = to;
  }
  return lefts === 0 || rights === 0;
}
