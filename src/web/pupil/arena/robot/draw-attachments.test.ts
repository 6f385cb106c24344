import { describe, expect, it } from 'vitest';
import { attachmentDrawings } from '#attachments/drawings';
import { completeOptions } from '#core/option';
import { maqueenLite } from '#robots/maqueen-lite/type';
import type { RobotState } from '#robots/robot';
import { attachmentFrontMm, attachmentReachMm, attachmentsAtStart, LENGTH_MM } from './draw-attachments';
import { readRobotDrawing } from './robot-drawing';

const atStart = (chosen: Readonly<Record<string, string>>) =>
  attachmentsAtStart(maqueenLite.mountMm, completeOptions(maqueenLite.options, chosen));

describe('Attachments before a run', () => {
  it('show what was chosen for each servo port, at the front edge', () => {
    expect(atStart({})).toEqual([]);
    expect(atStart({ S1: 'claw', echo: 'long-pulse' })).toEqual([
      { type: 'claw', port: 'S1', atMm: { x: 58, y: 0 }, angleDeg: 0, turnRad: {}, heightMm: 0, isHolding: false },
    ]);
    expect(atStart({ S1: 'forklift', S2: 'claw' }).map(({ type }) => type)).toEqual(['forklift', 'claw']);
  });

  it('show nothing on a robot that has no place for them', () => {
    expect(attachmentsAtStart(null, { S1: 'claw' })).toEqual([]);
  });

  it('make the picture reach far enough for a block on a fork: 188 mm from the axle of a Maqueen Lite', () => {
    const bare = { attachments: [] } as unknown as RobotState;
    expect(attachmentReachMm(bare)).toBe(0);
    expect(attachmentReachMm({ ...bare, attachments: atStart({ S1: 'forklift' }) })).toBe(188);
  });

  it('end ahead of the axle where their drawing ends: 122 mm with the claw of a Maqueen Lite', () => {
    expect(attachmentFrontMm()).toBe(0);
    expect(attachmentFrontMm(atStart({ S1: 'claw' }))).toBe(122);
    for (const [type, drawing] of Object.entries(attachmentDrawings))
      expect(LENGTH_MM[type], type).toBe(-readRobotDrawing(drawing).viewBox.y);
  });
});
