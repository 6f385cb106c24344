// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';

import { fetchDrawing } from '#robots/drawings';
import { robotTypes } from '#robots/index';

import { robotPicture } from './robot-picture';
import RobotPicture from './RobotPicture.vue';

const robots = await Promise.all(robotTypes.map(async (type) => ({ type, drawing: await fetchDrawing(type.id) })));

describe.each(robots)('the portrait of the $type.name', ({ type, drawing }) => {
  it('shows its whole drawing and no light', () => {
    const { box, body, lights } = robotPicture(drawing, false);
    expect(box).toEqual(body);
    expect(body.width).toBeGreaterThan(40);
    expect(lights).toEqual([]);
  });

  it('has 8 mm more room around with its lights on, for their glow', () => {
    const { box, body, lights } = robotPicture(drawing, true);
    expect(box).toEqual({ x: body.x - 8, y: body.y - 8, width: body.width + 16, height: body.height + 16 });
    for (const { x, y, radius, color } of lights) {
      expect(x).toBeGreaterThanOrEqual(body.x);
      expect(x).toBeLessThanOrEqual(body.x + body.width);
      expect(y).toBeGreaterThanOrEqual(body.y);
      expect(y).toBeLessThanOrEqual(body.y + body.height);
      expect(radius).toBeGreaterThan(0);
      expect(color).toMatch(/^#[0-9a-f]{6}$/);
    }
  });

  it('is an image of its own, which hides the marks for the lights under the body', () => {
    const { href } = robotPicture(drawing, false);
    const svg = decodeURIComponent(href.replace('data:image/svg+xml,', ''));
    expect(svg).toContain('<style>[id^="rgb-"]{display:none}</style>');
    expect(new DOMParser().parseFromString(svg, 'image/svg+xml').querySelector('svg')).not.toBeNull();
  });

  it('is for the eye alone', () => {
    const picture = mount(RobotPicture, { props: { type } });
    expect(picture.attributes()).toMatchObject({ 'aria-hidden': 'true', focusable: 'false' });
    expect(picture.findAll('circle')).toHaveLength(0);
  });

  it('lit draws the glow under the body below it and the lamps above it', () => {
    const { lights } = robotPicture(drawing, true);
    const picture = mount(RobotPicture, { props: { type, lit: true } });
    const drawn = [...picture.element.children].map(({ tagName }) => tagName).filter((tag) => tag !== 'defs');
    const below = lights.filter((light) => light.below).length;
    expect(drawn.indexOf('image')).toBe(below);
    expect(drawn.length).toBe(1 + below + 2 * (lights.length - below));
  });
});
