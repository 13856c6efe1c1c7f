import { download } from '../../app/files/download.ts';
import { Icon } from './controls.tsx';
import { Menu, type MenuItem } from './menu.tsx';
import { words } from './words.ts';

/** What can be drawn into a file. */
export interface Drawable {
  png(): Promise<Blob | null>;
  svg(title: string): string;
}

/** Saves a picture as PNG or SVG, and what else there is of it. */
export function SaveMenu({
  title,
  picture,
  testId,
  disabled,
  more = [],
}: {
  /** Of the picture: its heading, and the name of the file. */
  title: string;
  picture(): Drawable | null | undefined;
  testId: string;
  disabled?: boolean;
  more?: readonly MenuItem[];
}) {
  const file = fileName(title);
  const png = async (): Promise<void> => {
    const blob = await picture()?.png();
    if (blob) download(`${file}.png`, [blob], 'image/png');
  };
  const svg = (): void => {
    const drawn = picture();
    if (drawn) download(`${file}.svg`, [drawn.svg(title)], 'image/svg+xml');
  };
  const off = disabled ? { disabled } : {};
  return (
    <Menu
      label={`${words.save}: ${title}`}
      title={words.save}
      testId={`${testId}-save`}
      align="right"
      items={[
        { id: 'png', title: words.png, testId: `${testId}-png`, choose: () => void png(), ...off },
        { id: 'svg', title: words.svg, testId: `${testId}-svg`, choose: svg, ...off },
        ...more,
      ]}
    >
      <Icon name="export" />
    </Menu>
  );
}

/** A title as the name of a file. */
export const fileName = (title: string): string =>
  title
    .replace(/[^\p{L}\p{N}_-]+/gu, '-')
    .replace(/^-|-$/g, '')
    .toLowerCase() || 'plot';
