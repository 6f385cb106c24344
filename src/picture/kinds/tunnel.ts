import type { Tunnel } from '#scene/scene';

import { formOf, geometryOf } from '../form';
import type { Look } from '../look';
import { group, type Shape } from '../shapes';
import { boxFrame, type PictureKind } from './kind';

/** Tunnels: the dark over lines and fields, in a dashed edge. */
export const tunnel: PictureKind<Tunnel> = {
  mark: (tunnel, look) => [group(tunnel.at, roof(tunnel, look), tunnel.angle)],
  paper: (tunnel) => [
    group(tunnel.at, [{ ...geometryOf(formOf(tunnel), 0, 0), stroke: '#000000', width: 1 }], tunnel.angle),
  ],
  frame: boxFrame,
};

function roof(tunnel: Tunnel, { px }: Look): readonly Shape[] {
  const line = Math.max(1.5 * px, 2);
  return [
    { ...geometryOf(formOf(tunnel), 0, 2), fill: '#20242B', opacity: 0.42 },
    { ...geometryOf(formOf(tunnel), line / 2, 2), stroke: '#20242B', width: line, dash: [8, 5] },
  ];
}
