import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import type { Scene, SceneObject } from '#scene/scene';
import { selectTool } from './select-tool';
import { block, contextOf, course, drag, freely, mover, stroke, target, used, wall } from '../testing/desk';
import { nothingSelected, type Drag, type Selection } from './tool';

const selectionOf = (ids: readonly string[], robot = false): Selection => ({ ids, robot });
const adding = (one: Drag): Drag => ({ ...one, adds: true });

/** The selection after a drag. */
function chosen(scene: Scene, one: Drag, before: Selection = nothingSelected): Selection {
  const context = contextOf(scene, {}, before);
  const edit = selectTool.edit(one, context);
  const after = edit ? applyEdit(scene, edit) : scene;
  return selectTool.select?.(one, context, after) ?? before;
}

const after = (scene: Scene, one: Drag, before: Selection = nothingSelected): Scene =>
  used(selectTool, one, contextOf(scene, {}, before));

const pile = course(target('t', [300, 300]), stroke('s', [100, 300], [500, 300]), block('b', [300, 300]));

describe('selecting', () => {
  it('takes the topmost at a tap, the next below at each further one, then the topmost again', () => {
    const place = drag([300, 300]);
    const first = chosen(pile, place);
    expect(first).toEqual(selectionOf(['b']));
    const second = chosen(pile, place, first);
    expect(second).toEqual(selectionOf(['s']));
    const third = chosen(pile, place, second);
    expect(third).toEqual(selectionOf(['t']));
    expect(chosen(pile, place, third)).toEqual(selectionOf(['b']));
  });

  it('takes nothing at a tap on nothing', () => {
    expect(chosen(pile, drag([800, 800]), selectionOf(['b']))).toEqual(nothingSelected);
  });

  it('takes the start of the robot, which stands over everything', () => {
    expect(chosen(course(block('b', [600, 450])), drag([610, 450]))).toEqual(selectionOf([], true));
  });

  it('adds and takes away with Ctrl', () => {
    expect(chosen(pile, adding(drag([300, 300])), selectionOf(['t']))).toEqual(selectionOf(['t', 'b']));
    expect(chosen(pile, adding(drag([300, 300])), selectionOf(['t', 'b']))).toEqual(selectionOf(['t']));
    expect(chosen(pile, adding(drag([800, 800])), selectionOf(['t']))).toEqual(selectionOf(['t']));
  });

  it('catches with a frame whatever it touches, and shows the frame', () => {
    const frame = drag([520, 520], [250, 280]);
    expect(chosen(pile, frame)).toEqual(selectionOf(['t', 's', 'b']));
    expect(chosen(pile, drag([150, 150], [190, 310]))).toEqual(selectionOf(['s']));
    expect(chosen(pile, drag([560, 350], [700, 420]))).toEqual(selectionOf([], true));
    expect(chosen(pile, adding(drag([150, 150], [190, 310])), selectionOf(['b']))).toEqual(selectionOf(['b', 's']));
    expect(selectTool.marks?.(frame, contextOf(pile), true)).toEqual([
      { type: 'frame', from: { x: 520, y: 520 }, to: { x: 250, y: 280 } },
    ]);
    expect(selectTool.edit(frame, contextOf(pile))).toBeNull();
  });

  it('adds and takes away with each tap where several are chosen by finger, and a tap on nothing keeps them', () => {
    const several = (one: Drag, before: Selection): Selection | undefined =>
      selectTool.select?.(one, contextOf(pile, { several: true }, before), pile);
    expect(several(drag([300, 300]), selectionOf(['t']))).toEqual(selectionOf(['t', 'b']));
    expect(several(drag([300, 300]), selectionOf(['t', 'b']))).toEqual(selectionOf(['t']));
    expect(several(drag([800, 800]), selectionOf(['t']))).toEqual(selectionOf(['t']));
    expect(several(drag([150, 150], [190, 310]), selectionOf(['b']))).toEqual(selectionOf(['b', 's']));
  });

  it('catches with a lasso what it touches or has inside, not what lies in its bay, and shows it', () => {
    const scene = course(block('in', [200, 200]), block('bay', [300, 300]), block('out', [500, 500]), wall('w', [150, 350], [150, 500])); // prettier-ignore
    const lasso = drag([100, 100], [400, 100], [400, 250], [250, 250], [250, 400], [100, 400]);
    const context = contextOf(scene, { catches: 'lasso' });
    expect(selectTool.select?.(lasso, context, scene)).toEqual(selectionOf(['in', 'w']));
    expect(selectTool.marks?.(lasso, context, true)).toEqual([{ type: 'lasso', path: lasso.path }]);
    const around = drag([530, 350], [700, 350], [700, 550], [530, 550]);
    expect(selectTool.select?.(around, context, scene)).toEqual(selectionOf([], true));
  });

  it('takes a group at a tap, what lies below it at the next, and one of it at a double tap', () => {
    const inGroup = (object: SceneObject): SceneObject => ({ ...object, group: 'g' });
    const scene = course(target('t', [300, 300]), inGroup(block('b', [300, 300])), inGroup(stroke('s', [100, 320], [500, 320]))); // prettier-ignore
    const group = selectionOf(['b', 's']);
    expect(chosen(scene, drag([300, 300]))).toEqual(group);
    expect(chosen(scene, drag([300, 300]), group)).toEqual(selectionOf(['t']));
    expect(chosen(scene, adding(drag([300, 300])), selectionOf(['t']))).toEqual(selectionOf(['t', 'b', 's']));
    expect(chosen(scene, adding(drag([300, 300])), selectionOf(['t', 'b', 's']))).toEqual(selectionOf(['t']));
    const opened = (one: Drag, before: Selection) => selectTool.opens?.(one, contextOf(scene, {}, before));
    expect(opened(drag([300, 300]), group)).toEqual({ part: 'thing', id: 'b' });
    expect(opened(drag([200, 320]), group)).toEqual({ part: 'thing', id: 's' });
    expect(opened(drag([200, 320]), selectionOf(['s']))).toEqual({ part: 'points', id: 's' });
    expect(chosen(scene, drag([200, 320]), selectionOf(['b']))).toEqual(selectionOf(['s']));
  });

  it('drags a group as one, and one of it alone where that is selected', () => {
    const scene = course(...[block('a', [300, 300]), block('b', [500, 300])].map((one) => ({ ...one, group: 'g' })));
    const places = (moved: Scene) => moved.objects.map((object) => 'at' in object && object.at);
    expect(places(after(scene, drag([300, 300], [300, 500])))).toEqual([[300, 500], [500, 500]]); // prettier-ignore
    expect(places(after(scene, drag([300, 300], [300, 500]), selectionOf(['a'])))).toEqual([[300, 500], [500, 300]]); // prettier-ignore
  });

  it('begins a frame on what is locked', () => {
    const scene = course({ ...block('a', [300, 300]), lock: true }, block('b', [400, 300]));
    expect(after(scene, drag([300, 300], [420, 320]))).toBe(scene);
    expect(chosen(scene, drag([300, 300], [420, 320]))).toEqual(selectionOf(['b']));
  });

  it('moves nothing when a finger trembles', () => {
    expect(after(pile, drag([300, 300], [303, 301]))).toBe(pile);
  });
});

describe('moving', () => {
  it('moves what the drag began on, and selects it', () => {
    const one = drag([310, 305], [410, 355]);
    expect(after(pile, one).objects[2]).toEqual(block('b', [400, 350]));
    expect(chosen(pile, one)).toEqual(selectionOf(['b']));
  });

  it('moves the whole selection when the drag began on a part of it', () => {
    const moved = after(pile, drag([110, 300], [110, 400]), selectionOf(['s', 'b']));
    expect(moved.objects[0]).toBe(pile.objects[0]);
    expect(moved.objects.slice(1)).toEqual([stroke('s', [100, 400], [500, 400]), block('b', [300, 400])]);
    expect(chosen(pile, drag([110, 300], [110, 400]), selectionOf(['s', 'b']))).toEqual(selectionOf(['s', 'b']));
  });

  it('brings the held thing onto the 10 mm grid, unless it is free', () => {
    const scene = course(block('b', [303, 297]));
    expect(after(scene, drag([303, 297], [404, 297])).objects).toEqual([block('b', [400, 300])]);
    expect(after(scene, freely(drag([303, 297], [404, 297]))).objects).toEqual([block('b', [404, 297])]);
  });

  it('stays in whole mm', () => {
    const one: Drag = {
      ...freely(drag()),
      path: [
        { x: 300.4, y: 300.2 },
        { x: 350.9, y: 300.6 },
      ],
    };
    expect(after(course(block('b', [300, 300])), one).objects).toEqual([block('b', [351, 300])]);
  });

  it('copies with Alt: the originals stay, the copies are selected where they are dropped', () => {
    const scene = course(block('b', [300, 300]), wall('w', [100, 100], [200, 100]));
    const copies: Drag = { ...drag([300, 300], [400, 350]), alt: true };
    expect(after(scene, copies).objects).toEqual([...scene.objects, block('block-1', [400, 350])]);
    expect(chosen(scene, copies)).toEqual(selectionOf(['block-1']));
    expect(chosen(scene, copies, selectionOf(['b', 'w']))).toEqual(selectionOf(['block-1', 'wall-1']));
    expect(chosen(scene, { ...drag([300, 300]), alt: true })).toEqual(selectionOf(['b']));
  });

  it('leaves 10 mm of a thing in the arena, however far it is dragged', () => {
    expect(after(course(block('b', [300, 300])), drag([300, 300], [5000, 300])).objects).toEqual([
      block('b', [1215, 300]),
    ]);
    expect(after(course(block('b', [300, 300])), drag([300, 300], [300, -5000])).objects).toEqual([
      block('b', [300, -15]),
    ]);
  });

  it('keeps the start of the robot wholly inside', () => {
    expect(after(course(), drag([600, 450], [700, 500])).robot.at).toEqual([700, 500]);
    expect(after(course(), drag([600, 450], [5000, 5000])).robot.at).toEqual([1140, 870]);
  });
});

describe('handles', () => {
  it('move an end of a wall; it snaps to 45° and to other walls', () => {
    const scene = course(wall('w', [100, 100], [400, 100]), wall('o', [105, 400], [300, 500]));
    const held = selectionOf(['w']);
    expect(after(scene, drag([400, 100], [402, 300]), held).objects[0]).toEqual(wall('w', [100, 100], [350, 350]));
    expect(after(scene, drag([400, 100], [107, 403]), held).objects[0]).toEqual(wall('w', [100, 100], [105, 400]));
    expect(after(scene, freely(drag([100, 100], [107, 213])), held).objects[0]).toEqual(
      wall('w', [107, 213], [400, 100]),
    );
    expect(chosen(scene, drag([400, 100], [402, 300]), held)).toEqual(held);
  });

  it('never makes a wall without length', () => {
    const scene = course(wall('w', [100, 100], [400, 100]));
    expect(after(scene, drag([400, 100], [100, 100]), selectionOf(['w']))).toBe(scene);
  });

  it('size a block while its opposite corner stays', () => {
    const scene = course(block('b', [300, 300]));
    const [sized] = after(scene, drag([325, 325], [375, 355]), selectionOf(['b'])).objects;
    expect(sized).toMatchObject({ at: [325, 315], size: [100, 80] });
  });

  it('size a turned block along its own sides', () => {
    const scene = course(block('b', [300, 300], 2));
    const [sized] = after(scene, freely(drag([275, 325], [275, 425])), selectionOf(['b'])).objects;
    expect(sized).toMatchObject({ at: [300, 350], size: [150, 50] });
  });

  it('size a block at a side, with Alt about its middle, with Shift in its proportions', () => {
    const scene = course({ ...block('b', [300, 300]), size: [100, 50] } as SceneObject);
    const sized = (one: Drag): SceneObject | undefined => after(scene, one, selectionOf(['b'])).objects[0];
    expect(sized(drag([350, 300], [400, 310]))).toMatchObject({ at: [325, 300], size: [150, 50] });
    expect(sized(drag([250, 275], [240, 255]))).toMatchObject({ at: [295, 290], size: [110, 70] });
    expect(sized({ ...drag([350, 300], [370, 300]), alt: true })).toMatchObject({ at: [300, 300], size: [140, 50] });
    expect(sized({ ...drag([350, 325], [400, 330]), keeps: true })).toMatchObject({ at: [325, 313], size: [150, 75] });
    expect(sized({ ...drag([350, 300], [400, 300]), keeps: true })).toMatchObject({ at: [325, 300], size: [150, 75] });
  });

  it('size words in their proportions', () => {
    const words: SceneObject = { type: 'label', id: 'l', at: [300, 300], text: 'Start', height: 30, angle: 0 };
    const [sized] = after(course(words), drag([360, 321], [480, 321]), selectionOf(['l'])).objects;
    expect(sized).toMatchObject({ at: [360, 321], height: 60, text: 'Start' });
  });

  it('size a drawn line, and several things together, about the opposite corner; walls keep their thickness', () => {
    const scene = course(stroke('s', [100, 100], [150, 200], [200, 100]), wall('w', [300, 100], [300, 200]));
    const drawn = after(scene, freely(drag([210, 210], [330, 330])), selectionOf(['s'])).objects[0];
    expect(drawn).toEqual(stroke('s', [110, 110], [210, 310], [310, 110]));
    const both = after(scene, freely(drag([305, 210], [520, 210])), selectionOf(['s', 'w'])).objects;
    expect(both).toEqual([stroke('s', [110, 100], [210, 200], [310, 100]), wall('w', [510, 100], [510, 200])]);
  });

  it('size things and the start of the robot with them, which keeps its size', () => {
    const scene = course(block('b', [200, 300]));
    const held = selectionOf(['b'], true);
    const wider = after(scene, freely(drag([660, 378], [903, 378])), held);
    expect(wider.robot).toMatchObject({ at: [813, 450], scale: 1 });
    expect(wider.objects[0]).toMatchObject({ at: [213, 300], size: [75, 50] });
  });

  it('turn several together about their middle', () => {
    const scene = course(block('b', [300, 300]), block('c', [500, 300]));
    const turned = after(scene, drag([400, 341], [359, 300]), selectionOf(['b', 'c'])).objects;
    expect(turned).toEqual([block('b', [400, 200], 2), block('c', [400, 400], 2)]);
  });

  it('turn a block in steps of 15°, of 1° when it is free', () => {
    const scene = course(block('b', [300, 300]));
    const knob = [300, 341] as const; // 25 mm of block and twice the reach
    expect(after(scene, drag(knob, [259, 300]), selectionOf(['b'])).objects).toEqual([block('b', [300, 300], 2)]);
    expect(after(scene, drag(knob, [281, 336]), selectionOf(['b'])).objects).toMatchObject([{ angle: 30 }]);
    expect(after(scene, freely(drag(knob, [275, 333])), selectionOf(['b'])).objects).toMatchObject([{ angle: 37 }]);
  });

  it('turn the start of the robot in steps of 15°, of 1° when it is free', () => {
    const knob = [676, 450] as const; // 60 mm of robot and twice the reach
    expect(after(course(), drag(knob, [676, 490]), selectionOf([], true)).robot.heading).toBe(30);
    expect(after(course(), freely(drag(knob, [676, 490])), selectionOf([], true)).robot.heading).toBe(28);
  });

  it('move the turning point of a mover', () => {
    const scene = course(mover('m', [200, 200], [500, 200]));
    expect(after(scene, drag([500, 200], [204, 600]), selectionOf(['m'])).objects).toEqual([
      mover('m', [200, 200], [200, 600]),
    ]);
  });

  it('move the ends of a straight line, but not of a drawn one', () => {
    const straight = course(stroke('s', [100, 100], [400, 100]));
    expect(after(straight, drag([400, 100], [503, 104]), selectionOf(['s'])).objects).toEqual([
      stroke('s', [100, 100], [500, 100]),
    ]);
    const bent = course(stroke('s', [100, 100], [400, 100], [400, 300]));
    expect(after(bent, drag([400, 300], [500, 300]), selectionOf(['s'])).objects).toEqual([
      stroke('s', [200, 100], [500, 100], [500, 300]),
    ]);
  });

  it('leave enough of a small block to move it with a finger that reaches 60 mm', () => {
    const finger: Drag = { ...drag([305, 305], [505, 305]), reachMm: 60 };
    expect(after(course(block('b', [300, 300])), finger, selectionOf(['b'])).objects).toEqual([block('b', [500, 300])]);
  });
});
