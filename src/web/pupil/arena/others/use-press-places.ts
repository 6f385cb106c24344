import { computed, onBeforeUnmount, shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { slowly } from '../../../kit/slowly';
import type { PxBox } from '../view/moving-window';
import { bodyBox, nameBox, type DeviceRing } from './draw-ring';

/** A finger needs more than the eye: this far above and below a name it still counts, in px. */
export const FINGER_PX = 10;

/** The place of the device whose name, or whose robot if that counts, too, is at a point of the picture, in px. */
export function deviceAt(
  rings: readonly DeviceRing[],
  { x, y }: { readonly x: number; readonly y: number },
  body: (ring: DeviceRing) => boolean,
): number | null {
  const within = ({ left, top, width, height }: PxBox, more: number): boolean =>
    x >= left && x <= left + width && y >= top - more && y <= top + height + more;
  const hit = rings.findLast((ring) => within(nameBox(ring), FINGER_PX) || (body(ring) && within(bodyBox(ring), 0)));
  return hit?.place ?? null;
}

/** Inputs of `usePressPlaces`. */
interface Pressed {
  /** An element exactly above the picture, inside the element that receives its presses. */
  readonly cover: Readonly<ShallowRef<HTMLElement | null>>;
  readonly rings: () => readonly DeviceRing[];
  /** True if a press on the robot itself counts as one on its name. */
  readonly body: (ring: DeviceRing) => boolean;
  readonly choose: (place: number) => void;
}

/**
 * Presses on the names of the robots, which are painted with them. Elements of the page that drive along are slow, so
 * there are some only while a mouse is over the picture, for its pointer and the words at it.
 *
 * @returns the rings as those elements follow them; `null`: no mouse is there
 */
export function usePressPlaces({ cover, rings, body, choose }: Pressed): Readonly<Ref<readonly DeviceRing[] | null>> {
  const isNear = shallowRef(false);
  const enter = ({ pointerType }: PointerEvent): void => {
    isNear.value = pointerType !== 'touch';
  };
  const leave = (): void => {
    isNear.value = false;
  };
  function press(event: PointerEvent): void {
    const origin = cover.value?.getBoundingClientRect();
    if (origin === undefined || event.button !== 0) return;
    const place = deviceAt(rings(), { x: event.clientX - origin.left, y: event.clientY - origin.top }, body);
    if (place === null) return;
    event.stopPropagation();
    choose(place);
  }
  function listen(host: HTMLElement | null | undefined): () => void {
    host?.addEventListener('pointermove', enter);
    host?.addEventListener('pointerleave', leave);
    host?.addEventListener('pointerdown', press, { capture: true });
    return () => {
      host?.removeEventListener('pointermove', enter);
      host?.removeEventListener('pointerleave', leave);
      host?.removeEventListener('pointerdown', press, { capture: true });
    };
  }
  let end = listen(null);
  watch(
    () => cover.value?.parentElement,
    (host) => {
      end();
      end = listen(host);
    },
    { immediate: true, flush: 'post' },
  );
  onBeforeUnmount(() => end());
  return slowly(computed(() => (isNear.value ? rings() : null)));
}
