import { describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import { drawScene } from './draw-scene';
import { lightPalette } from '../model/palette';
import type { SceneKinds } from './scene-kinds';
import { fitView } from '../view/view-transform';

/** Takes everything and shows nothing. */
const nowhere = new Proxy({}, { get: () => () => ({ width: 0 }), set: () => true }) as CanvasRenderingContext2D;

describe('what stands still', () => {
  it('is painted from the floor up: grounds of zones, lines, numbers of zones, then what stands', () => {
    const order: string[] = [];
    const told = (name: string) => () => void order.push(name);
    const kinds: SceneKinds = {
      background: told('background'),
      signs: told('words'),
      spikes: told('spikes'),
      inRun: (scene) => scene,
      carried: () => [],
      carriedTag: told('carried tag'),
      mover: told('mover'),
      waiting: told('waiting'),
    };
    const zones = { drawZones: told('zones'), drawZoneSigns: told('zone signs') };
    const background = { at: [0, 0], size: [100, 100], cells: [1, 1], levels: '', picture: '' } as const;
    const scene = { ...defaultScene(), background };
    const canvas = { widthPx: 800, heightPx: 600 };
    const view = fitView(scene.size, canvas);
    drawScene(
      nowhere,
      view,
      { scene, zones, sheets: null, kinds, verdict: null },
      canvas,
      lightPalette,
      (_, __, layer) => order.push(layer),
    );
    expect(order).toEqual(['background', 'zones', 'lines', 'zone signs', 'standing']);
  });
});
