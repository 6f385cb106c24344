import { computed, type ComputedRef } from 'vue';

import type { OptionValues } from '#core/option';
import { useDrawing } from '../../../session/work/hardware/use-drawing';
import type { RobotLook } from '../model/arena-model';
import { readRobotDrawing } from './robot-drawing';
import type { RobotPainting } from './robot-painting';
import { createSpriteShelf } from './robot-sprite';
import { TreadShelf } from './tread-sprite';
import { TurnedBody } from './turned-body';

/**
 * The drawing and sprites of a robot; `null` without a robot and until its drawing is loaded.
 *
 * @param options its options, which name the parts that are plugged in
 * @param patience see `TurnedBody`
 */
export function usePainting(
  robot: () => RobotLook | null,
  options: () => OptionValues,
  redraw: () => void,
  patience = 0,
): ComputedRef<RobotPainting | null> {
  const svg = useDrawing(robot, options);
  return computed(() => {
    const look = robot();
    if (look === null || svg.value === null) return null;
    const drawing = readRobotDrawing(svg.value);
    return {
      look,
      drawing,
      sprites: createSpriteShelf(drawing, redraw),
      turned: new TurnedBody(patience),
      treads: new TreadShelf(),
      redraw,
    };
  });
}
