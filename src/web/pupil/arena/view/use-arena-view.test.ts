// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick, shallowRef, useTemplateRef } from 'vue';
import { mount } from '@vue/test-utils';

import { defaultScene, type Scene } from '#scene/scene';

import { samples } from '../../../app/testing/editing';
import '../../../app/testing/mount-on';
import { useArenaView, type ArenaView } from './use-arena-view';
import { toPx } from './view-transform';

/** Sets the size of the element, as the browser would report it. */
let resize: (width: number, height: number) => void = () => undefined;

beforeEach(() => {
  class Sizes {
    constructor(told: ResizeObserverCallback) {
      resize = (width, height) => told([{ contentRect: { width, height } } as ResizeObserverEntry], this);
    }
    readonly observe = (): void => undefined;
    readonly unobserve = (): void => undefined;
    readonly disconnect = (): void => undefined;
  }
  vi.stubGlobal('ResizeObserver', Sizes);
});

/** A view of an arena of 1200 × 900 mm in an element of 800 × 600 px. */
function viewed() {
  const arena = shallowRef<readonly [number, number]>([1200, 900]);
  let pans = 0;
  let view: ArenaView | null = null;
  const Host = defineComponent({
    setup() {
      view = useArenaView(useTemplateRef<HTMLElement>('host'), () => arena.value, () => (pans += 1)); // prettier-ignore
      return () => h('div', { ref: 'host' });
    },
  });
  mount(Host, { attachTo: document.body });
  resize(800, 600);
  const scene = (at: readonly [number, number]): Scene => ({ ...defaultScene(), objects: [{ ...samples.block, at }] });
  return { view: view as unknown as ArenaView, arena, scene, pans: () => pans };
}
const middle = { x: 600, y: 450 };

describe('the view of the arena', () => {
  it('shows all of the arena at first, and after the page has changed its size', () => {
    const { view } = viewed();
    const whole = () => {
      const [low, high] = [toPx(view.view.value, { x: 0, y: 0 }), toPx(view.view.value, { x: 1200, y: 900 })];
      const { widthPx, heightPx } = view.canvas.value;
      return low.x >= 0 && high.y >= 0 && high.x <= widthPx && low.y <= heightPx;
    };
    expect([whole(), view.percent.value]).toEqual([true, 100]);
    resize(400, 700);
    expect([whole(), view.percent.value, view.canvas.value]).toEqual([true, 100, { widthPx: 400, heightPx: 700 }]);
  });

  it('shows with everything what lies outside of the arena, too', () => {
    const { view, scene } = viewed();
    view.showAll(scene([500, 500]));
    expect(view.percent.value).toBe(100);
    view.showAll(scene([3000, 500]));
    expect(view.percent.value).toBeLessThan(50);
    for (const at of [
      { x: 0, y: 0 },
      { x: 3025, y: 525 },
    ]) {
      const { x, y } = toPx(view.view.value, at);
      expect(x > 0 && x < 800 && y > 0 && y < 600).toBe(true);
    }
  });

  it('shows a thing large, in the middle, with room around it', () => {
    const { view } = viewed();
    view.showBox({ minX: 550, minY: 425, maxX: 650, maxY: 475 });
    const [left, right] = [toPx(view.view.value, { x: 550, y: 450 }), toPx(view.view.value, { x: 650, y: 450 })];
    expect(right.x - left.x).toBeGreaterThan(350);
    expect(Math.abs((left.x + right.x) / 2 - 400)).toBeLessThan(15);
    view.showBox({ minX: 2000, minY: 2000, maxX: 2050, maxY: 2050 });
    expect(toPx(view.view.value, { x: 2025, y: 2025 }).x).toBeGreaterThan(300);
  });

  it('shows the arena about in its true size: 96 px to an inch', () => {
    const { view } = viewed();
    view.showTrueSize();
    expect(view.view.value.pxPerMm * 25.4).toBeCloseTo(96, 6);
  });

  it('is not troubled by an element that is out of sight', () => {
    const { view } = viewed();
    resize(0, 0);
    expect(view.canvas.value).toEqual({ widthPx: 800, heightPx: 600 });
  });

  it('keeps what is under the pointer there while it zooms', () => {
    const { view } = viewed();
    const before = toPx(view.view.value, { x: 300, y: 300 });
    view.zoomBy(2, before);
    const after = toPx(view.view.value, { x: 300, y: 300 });
    expect([after.x, after.y].map(Math.round)).toEqual([before.x, before.y].map(Math.round));
    expect(view.percent.value).toBe(200);
  });

  it('keeps its zoom when the page changes its size', () => {
    const { view } = viewed();
    view.zoomBy(3);
    const scale = view.view.value.pxPerMm;
    resize(700, 600);
    expect(view.view.value.pxPerMm).toBeCloseTo(scale);
  });

  it('is moved by hand only where something is out of sight', () => {
    const { view, pans } = viewed();
    const before = view.view.value;
    view.panBy({ x: 50, y: 0 });
    expect([view.view.value === before, pans()]).toEqual([true, 0]);
    view.zoomBy(3);
    const at = toPx(view.view.value, middle);
    view.panBy({ x: 50, y: -20 });
    const to = toPx(view.view.value, middle);
    expect([Math.round(to.x - at.x), Math.round(to.y - at.y), pans()]).toEqual([50, -20, 1]);
  });

  it('shows all of it again with one press, and from then on follows the page’s size', () => {
    const { view } = viewed();
    view.zoomBy(3);
    view.fit();
    expect(view.percent.value).toBe(100);
    resize(400, 300);
    expect(view.percent.value).toBe(100);
  });

  it('shows all of another arena', async () => {
    const { view, arena } = viewed();
    view.zoomBy(3);
    arena.value = [3000, 2000];
    await nextTick();
    expect(view.percent.value).toBe(100);
    expect(toPx(view.view.value, { x: 3000, y: 0 }).x).toBeLessThanOrEqual(800);
  });

  it('follows the robot when it leaves the middle of a zoomed picture, and not where all is in sight', () => {
    const { view } = viewed();
    expect(view.follow({ x: 1190, y: 450 }, 16)).toBe(false);
    view.zoomBy(4);
    const far = { x: 1000, y: 450 };
    const before = toPx(view.view.value, far).x;
    expect(view.follow(far, 100)).toBe(true);
    expect(toPx(view.view.value, far).x).toBeLessThan(before);
    for (let times = 0; times < 200; times += 1) view.follow(far, 16);
    expect(toPx(view.view.value, far).x).toBeLessThan(600);
    expect(view.follow(far, 16)).toBe(false);
  });

  it('brings a place that is out of sight into it', () => {
    const { view } = viewed();
    view.zoomBy(4);
    view.showPlace({ x: 1150, y: 50 });
    const { x, y } = toPx(view.view.value, { x: 1150, y: 50 });
    expect([x > 0 && x < 800, y > 0 && y < 600]).toEqual([true, true]);
  });
});
