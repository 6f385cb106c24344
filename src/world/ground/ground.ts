import type { FieldShape, FloorGrid, StrokeHandle, StrokeShape } from '../shapes';
import { meanByChords, type Under } from './chords';
import { bandCoverage } from './coverage';
import { fieldOf, underFields, type Field } from './fields';
import { createFloorPicture, type FloorPicture } from './floor-grid';
import { distanceSquared, segmentsOf, type Painted, type Segment } from './segment';
import { createSegmentGrid } from './segment-grid';

/** The drawing on the floor. */
export interface Ground {
  /** Paints on top of what is there. */
  addStroke(stroke: StrokeShape): StrokeHandle;
  /** Paints a field: over fields that are there, under all strokes. */
  addField(field: FieldShape): StrokeHandle;
  /** Lays a picture under the strokes and fields, or removes it. Throws RangeError if its reflectances do not fit its cells. */
  setFloor(grid: FloorGrid | null): void;
  /** Mean reflectance under a round spot, 0 black … 1 bare floor; the spot's radius must be above 0. */
  reflectanceAt(x: number, y: number, radiusMm: number): number;
}

/**
 * Strokes, fields and a picture under them. A spot wholly inside or outside the ink, or beside a single straight piece, is
 * computed exactly; crossings, joints, ends and strokes on strokes by chords (docs/decisions/0015-ground-coverage.md).
 */
export function createGround(): Ground {
  return new StrokesOnFloor();
}

class StrokesOnFloor implements Ground {
  private readonly grid = createSegmentGrid();
  private picture: FloorPicture | null = null;
  /** From the highest layer to the lowest. */
  private fields: Field[] = [];
  private layers = 0;
  private looks = 0;
  /** The pieces that reach into the present spot but do not fill it, from the topmost layer to the lowest. */
  private edges: Segment[] = [];
  /** The topmost stroke that fills the spot. */
  private filling: Painted | null = null;

  addStroke(stroke: StrokeShape): StrokeHandle {
    const painted: Painted = {
      halfWidth: stroke.widthMm / 2,
      reflectance: stroke.reflectance,
      layer: this.layers++,
    };
    const segments = segmentsOf(stroke.pointsMm, painted);
    for (const segment of segments) this.grid.add(segment);
    return {
      setLayer: (layer) => {
        painted.layer = layer;
        this.layers = Math.max(this.layers, layer + 1);
      },
      remove: () => {
        for (const segment of segments.splice(0)) this.grid.remove(segment);
      },
    };
  }

  addField(shape: FieldShape): StrokeHandle {
    const field = fieldOf(shape, shape.reflectance, this.layers++);
    const sort = (): void => void this.fields.sort((one, other) => other.layer - one.layer);
    this.fields.unshift(field);
    return {
      setLayer: (layer) => {
        field.layer = layer;
        this.layers = Math.max(this.layers, layer + 1);
        sort();
      },
      remove: () => void (this.fields = this.fields.filter((each) => each !== field)),
    };
  }

  setFloor(floor: FloorGrid | null): void {
    this.picture = floor && createFloorPicture(floor);
  }

  reflectanceAt(x: number, y: number, radius: number): number {
    this.gather(x, y, radius);
    const { filling } = this;
    const under = filling === null ? this.underAt(x, y, radius) : filling.reflectance;
    const seen = filling === null ? this.edges : this.edges.filter(({ painted }) => painted.layer > filling.layer);
    const [only] = seen;
    if (only && seen.length === 1 && typeof under === 'number' && isStraightUnder(only, x, y, radius)) {
      const distance = Math.sqrt(distanceSquared(only, x, y));
      const share = bandCoverage(distance, only.painted.halfWidth, radius);
      return under + share * (only.painted.reflectance - under);
    }
    return meanByChords(x, y, radius, seen, under);
  }

  /** The ground below all strokes. */
  private underAt(x: number, y: number, radius: number): Under {
    const below = this.picture ?? 1;
    return this.fields.length === 0 ? below : underFields(this.fields, below, x, y, radius);
  }

  private gather(x: number, y: number, radius: number): void {
    const look = ++this.looks;
    this.edges = [];
    this.filling = null;
    this.grid.near(x, y, radius, (segment) => {
      if (segment.seen === look) return;
      segment.seen = look;
      const { painted } = segment;
      const squared = distanceSquared(segment, x, y);
      const outer = painted.halfWidth + radius;
      if (squared >= outer * outer) return;
      const inner = painted.halfWidth - radius;
      if (inner < 0 || squared > inner * inner) insertByLayer(this.edges, segment);
      else if (this.filling === null || painted.layer > this.filling.layer) this.filling = painted;
    });
  }
}

/** Puts a piece behind those of its layer and of higher ones. */
function insertByLayer(pieces: Segment[], piece: Segment): void {
  let place = pieces.length;
  pieces.push(piece);
  for (; place > 0; place--) {
    const above = pieces[place - 1];
    if (!above || above.painted.layer >= piece.painted.layer) break;
    pieces[place] = above;
  }
  pieces[place] = piece;
}

/** True if the spot meets neither end of a piece. */
function isStraightUnder({ ax, ay, ex, ey, length }: Segment, x: number, y: number, radius: number): boolean {
  const along = (x - ax) * ex + (y - ay) * ey;
  return along >= radius && along <= length - radius;
}
