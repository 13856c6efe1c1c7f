import type { TypesetBody } from '../../core/model/typeset.ts';
import { equations } from './words.ts';
import { Chip } from '../../ui/kit/chip.tsx';
import { useBook } from './context.ts';
import { Formula } from './formula.tsx';

const words = equations.body;

/** Attitude, place, velocities, inertia and energy of each body, and of the frames that carry them. */
export function BodiesSection() {
  const { typeset } = useBook();
  return (
    <>
      {typeset.frames.length > 0 && <h4>{equations.headings.frames}</h4>}
      {typeset.frames.flatMap(({ id, attitude, angular }) => [
        <Formula key={`${id}.R`} latex={attitude} title={`${id} ${words.attitude}`} label={words.attitude} />,
        <Formula key={`${id}.w`} latex={angular} title={`${id} ${words.angular}`} label={words.angular} />,
      ])}
      {typeset.bodies.map((body) => (
        <BodyFormulas key={body.id} body={body} />
      ))}
    </>
  );
}

function BodyFormulas({ body }: { body: TypesetBody }) {
  const { view } = useBook();
  const meta = view.meta.bodies.find(({ id }) => id === body.id);
  const name = meta?.label ?? body.id.replaceAll('-', ' ');
  const lines = [
    ['mass', body.mass === '0' ? null : `m = ${body.mass}`],
    ['inertia', body.inertia],
    ['attitude', body.attitude],
    ['position', body.position],
    ['velocity', body.velocity],
    ['angular', body.angular],
    ['kinetic', body.kinetic],
  ] as const;
  return (
    <section aria-label={name} data-testid={`equations-body-${body.id}`}>
      <h4>
        <Chip role={meta?.role ?? 'neutral'} />
        {name}
      </h4>
      {lines.map(
        ([kind, latex]) =>
          latex && <Formula key={kind} latex={latex} title={`${name}, ${words[kind]}`} label={words[kind]} />,
      )}
    </section>
  );
}
