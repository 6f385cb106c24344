import { nextTick, onBeforeUnmount, onMounted, shallowRef, watch, type ShallowRef } from 'vue';

import type { LayoutParts } from '../layout/parts';
import { cardPlace, type Area, type CardPlace } from './card-place';
import './make-room.css';

/** Keeps the card beside, above or below the arena while panes are moved and windows turned. */
export function useCardPlace({ layout, alone }: LayoutParts): ShallowRef<CardPlace | null> {
  const place = shallowRef<CardPlace | null>(null);
  const root = document.documentElement;
  const observer = new ResizeObserver(() => measure());

  function measure(): void {
    const isAlone = alone.isAlone.value;
    const panes = isAlone ? wholeWindow() : areaInside('.panes');
    if (panes === null) return;
    // On a phone the arena has all the room, or makes some: only where it would be matters.
    const hasAll = isAlone || layout.arrangement.value === 'phone';
    place.value = cardPlace({
      panes,
      arena: hasAll ? panes : areaOf('.pane-arena'),
      console: hasAll ? null : areaOf('.pane-console'),
      kept: areaOf('[data-stays-in-sight]'),
      isAlone: hasAll,
    });
    makeRoom(root, place.value);
  }
  function follow(): void {
    observer.disconnect();
    for (const pane of document.querySelectorAll('.panes, .pane-arena, .pane-console, #editor-panel'))
      observer.observe(pane);
    measure();
  }
  watch([layout.arrangement, layout.isShown, alone.isAlone], () => void nextTick(follow));
  onMounted(follow);
  addEventListener('resize', measure);
  onBeforeUnmount(() => {
    observer.disconnect();
    removeEventListener('resize', measure);
    makeRoom(root, null);
  });
  return place;
}

function makeRoom({ classList, style }: HTMLElement, place: CardPlace | null): void {
  const { kind, area } = place ?? { kind: null, area: { left: 0, top: 0, right: 0, bottom: 0 } };
  classList.toggle('task-beside', kind === 'beside');
  classList.toggle('task-sheet', kind === 'sheet');
  style.setProperty('--task-width', `${String(area.right - area.left)}px`);
  style.setProperty('--task-height', `${String(area.bottom - area.top)}px`);
  style.setProperty('--task-lift', `${String(innerHeight - area.top)}px`);
}

const wholeWindow = (): Area => ({ left: 0, top: 0, right: innerWidth, bottom: innerHeight });

/** The area of an element without its padding at the top; `null`: it is not shown. */
function areaInside(css: string): Area | null {
  const area = areaOf(css);
  const host = document.querySelector(css);
  if (area === null || host === null) return null;
  return { ...area, top: area.top + (Number.parseFloat(getComputedStyle(host).paddingTop) || 0) };
}

function areaOf(css: string): Area | null {
  const { left = 0, top = 0, right = 0, bottom = 0 } = document.querySelector(css)?.getBoundingClientRect() ?? {};
  return right > left && bottom > top ? { left, top, right, bottom } : null;
}
