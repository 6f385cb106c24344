import type { Background } from '#scene/scene';
import { toPx, type View } from '../view/view-transform';

/** Pictures of backgrounds, made when they are first needed. */
export interface BackgroundShelf {
  /** The picture of this background, or `null` while it is being read and when it cannot be. */
  of(background: Background): CanvasImageSource | null;
}

/**
 * Makes a shelf that holds the picture of one background: a course has one, and pictures are large.
 *
 * @param ready called when a picture has been read
 */
export function createBackgroundShelf(ready: () => void): BackgroundShelf {
  let picture = '';
  let levels = '';
  let source: CanvasImageSource | null = null;
  return {
    of(background) {
      if (background.picture === picture && background.levels === levels) return source;
      picture = background.picture;
      levels = background.levels;
      source = null;
      if (picture === '') {
        // What inflates the grid is fetched with the first one.
        import('./background-grid')
          .then(({ gridPicture }) => {
            if (levels !== background.levels) return; // another one has come meanwhile
            source = gridPicture(background);
            ready();
          })
          .catch(() => undefined); // without a connection the floor stays bare
        return source;
      }
      const image = new Image();
      image.onload = () => {
        if (picture !== background.picture) return; // another one has come meanwhile
        source = image;
        ready();
      };
      image.src = picture;
      return source;
    },
  };
}

/** Draws a background as if it were printed on the floor: what is white in it shows the floor. */
export function drawBackground(
  context: CanvasRenderingContext2D,
  view: View,
  background: Background,
  shelf: BackgroundShelf,
): void {
  const source = shelf.of(background);
  if (source === null) return;
  const [width, height] = background.size;
  const corner = toPx(view, { x: background.at[0], y: background.at[1] + height });
  const cellPx = (width / background.cells[0]) * view.pxPerMm;
  context.save();
  context.globalCompositeOperation = 'multiply';
  context.imageSmoothingEnabled = background.picture !== '' || cellPx < 2;
  context.drawImage(source, corner.x, corner.y, width * view.pxPerMm, height * view.pxPerMm);
  context.restore();
}
