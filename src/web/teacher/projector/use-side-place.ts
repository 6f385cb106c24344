import { computed, onScopeDispose, shallowRef, watchEffect, type ComputedRef, type ShallowRef } from 'vue';

import type { Scene } from '#scene/scene';

import { sidePlace, type SidePlace } from './side-place';

/** Keeps task and timer beside or above the course while windows and courses change; the arena makes room. */
export function useSidePlace(scene: Readonly<ShallowRef<Scene>> | ComputedRef<Scene>): ComputedRef<SidePlace> {
  const size = shallowRef({ width: innerWidth, height: innerHeight });
  const measure = (): void => void (size.value = { width: innerWidth, height: innerHeight });
  const place = computed(() => {
    const [width, height] = scene.value.size;
    return sidePlace(size.value.width, size.value.height, width / height);
  });
  const { classList, style } = document.documentElement;
  addEventListener('resize', measure);
  watchEffect(() => {
    const { kind, px } = place.value;
    classList.add('projector');
    classList.toggle('projector--above', kind === 'above');
    style.setProperty('--side-px', `${String(px)}px`);
  });
  onScopeDispose(() => {
    removeEventListener('resize', measure);
    classList.remove('projector', 'projector--above');
    style.removeProperty('--side-px');
  });
  return place;
}
