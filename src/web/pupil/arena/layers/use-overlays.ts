import { shallowRef, watch, type ShallowRef } from 'vue';
import type { Snapshot } from '#simulation/snapshot';
import type { ArenaOptions } from '../model/arena-model';
import type { MovingScene } from './draw-moving';
import type { OverlayParts, OverlayPicture, Overlays } from './overlays';
import type { Trail } from '../../../session/run/trail';

/** Sources of the overlays. */
export interface OverlaySources {
  readonly options: () => ArenaOptions;
  readonly newest: () => Snapshot | null;
  /** Simulated time for the cone's arcs, or `null` to freeze them. */
  readonly breathUs: () => number | null;
  readonly trail: () => Trail;
  /** `null` while the trail is hidden. */
  readonly trailCanvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  readonly place: () => Pick<OverlayParts, 'view' | 'canvas' | 'ratio' | 'palette'>;
  /** Called when the code for them has been loaded. */
  readonly ready: () => void;
}

/** Adds to the overlays of the robot that is shown. */
export type AroundRobot = (overlay: OverlayPicture | null) => OverlayPicture | null;

/** The overlays of a scene. Their code is loaded when the first one is wanted. */
export function useOverlays(sources: OverlaySources): (scene: MovingScene) => OverlayPicture | null {
  const overlays = shallowRef<Overlays | null>(null);
  const hasSight = (): boolean => {
    const { lidar, ultrasonic, colours, camera } = sources.newest()?.robot?.state ?? {};
    return Boolean(lidar) || Boolean(ultrasonic) || Boolean(colours ?? camera);
  };
  const isWanted = (): boolean => {
    const { cone, spots, centre, trace, lights } = sources.options();
    return spots || centre || trace || Object.keys(lights).length > 0 || (cone && hasSight());
  };
  const fetch = (): void => {
    import('./overlays').then(
      ({ createOverlays }) => {
        overlays.value ??= createOverlays();
        sources.ready();
      },
      () => undefined, // no connection at the moment: fetched with the next switch
    );
  };
  watch([sources.options, hasSight], () => isWanted() && overlays.value === null && fetch(), { immediate: true });
  return ({ arena, robot, robotHeld }) => {
    if (!isWanted() || overlays.value === null) return null;
    const options = sources.options();
    const snapshot = sources.newest();
    const parts: OverlayParts = {
      ...sources.place(),
      options,
      arena,
      timeUs: snapshot?.timeUs ?? null,
      breathUs: sources.breathUs(),
      robot: robot && { now: robot.now, look: robot.painting.look, scale: robot.scale, held: robotHeld },
      lights: (snapshot?.lights ?? []).flatMap(({ pin, colors }) => {
        const form = options.lights[pin];
        return form === undefined ? [] : [{ form, colors }];
      }),
      trail: sources.trail(),
      trailCanvas: sources.trailCanvas.value,
    };
    return overlays.value.picture(parts, performance.now());
  };
}
