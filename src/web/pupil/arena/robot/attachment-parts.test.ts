import { describe, expect, it } from 'vitest';
import { attachmentTitles } from '#attachments/options';
import { attachmentDrawings } from '#attachments/drawings';
import { CLOSED_DEG, OPEN_DEG } from '#attachments/claw/claw';
import { attachmentTypes } from '#attachments/types';
import { fetchDrawing } from '#robots/drawings';
import { robotTypes } from '#robots/index';
import { partsOf, sonarOf } from './attachment-parts';
import { readRobotDrawing } from './robot-drawing';

const idsOf = (type: string): readonly string[] => partsOf(attachmentDrawings[type] ?? '').map(({ id }) => id);

describe('The drawings of the attachments', () => {
  it('are there for every kind that can be chosen', () => {
    const ids = Object.keys(attachmentTitles).filter((id) => id !== 'none');
    expect(Object.keys(attachmentDrawings).sort()).toEqual([...ids].sort());
    expect(attachmentTypes.map(({ id }) => id).sort()).toEqual([...ids].sort());
  });

  it('have a part for everything that moves', () => {
    expect(idsOf('claw')).toEqual(['base', 'jaw-right', 'jaw-left']);
    expect(idsOf('forklift')).toEqual(['fork', 'mast']);
    expect(idsOf('loader')).toContain('fork');
    expect(idsOf('push')).toContain('sonar');
  });

  it.each(Object.keys(attachmentDrawings))(
    '%s: every part is a document of its own that is read whole, from less than 6 kB',
    (type) => {
      const drawing = attachmentDrawings[type] ?? '';
      expect(drawing.length).toBeLessThan(6000);
      for (const { svg, viewBox } of partsOf(drawing)) {
        expect(svg).toMatch(/^<svg xmlns="http:\/\/www\.w3\.org\/2000\/svg"[^>]*>.*<\/svg>$/s);
        expect(svg.match(/<g id="(?!claw-jaw)/g)).toHaveLength(1);
        expect(viewBox.width).toBeGreaterThan(40);
      }
    },
  );

  it('show the claw open by 50° while nothing runs, as its servo stands then', () => {
    const [, right, left] = partsOf(attachmentDrawings['claw'] ?? '');
    expect(left?.restRad).toBeCloseTo((50 / 180) * Math.PI, 9);
    expect(right?.restRad).toBeCloseTo((-50 / 180) * Math.PI, 9);
    expect(left?.pivot).toEqual({ x: -15, y: -12 });
    expect(right?.pivot).toEqual({ x: 15, y: -12 });
    expect([OPEN_DEG, CLOSED_DEG]).toEqual([30, 86]);
  });
});

/** All but those that look ahead with a lidar, which no servo turns. */
const robotsWithSonar = robotTypes.filter(
  ({ mountMm, options }) => mountMm !== null && options.every(({ id }) => id !== 'lidar'),
);

describe.each(robotsWithSonar.map((type) => [type.name, type] as const))('The drawing of the %s', (_name, type) => {
  it('has a distance sensor that a servo can turn about its board, ahead of the axle', async () => {
    const sonar = sonarOf(readRobotDrawing(await fetchDrawing(type.id)));
    expect(sonar?.head.svg).toContain('id="ultrasonic"');
    expect(sonar?.body.svg).not.toContain('id="ultrasonic"');
    expect(sonar?.head.pivot.x).toBeCloseTo(0, 9);
    const mountMm = type.mountMm?.x ?? NaN;
    expect(Math.abs(-(sonar?.head.pivot.y ?? NaN) - mountMm)).toBeLessThan(20);
  });
});

describe('A drawing without a distance sensor', () => {
  it('has none to turn', () => {
    expect(sonarOf(readRobotDrawing('<svg viewBox="0 0 10 10"><g id="body"/></svg>'))).toBeNull();
  });
});
