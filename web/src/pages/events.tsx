// Events, newest first, as they come: of the farm, or of one job.

import { useEffect, useMemo, useState } from 'preact/hooks';
import { inAddress } from '../api/client';
import { live, useAnswer, useLive } from '../api/hooks';
import { mergedEvents } from '../api/live';
import type { FarmEvent } from '../api/types';
import { moment } from '../logic/format';
import { jobAddress } from '../logic/router';
import { textFits } from '../logic/sort_filter';
import { Search } from '../ui/fields';
import { Link } from '../ui/navigation';
import { Empty, Name, Said, TaskLink, Trouble } from '../ui/parts';

const mostShown = 500;
const mostKept = 2000;

function EventRow({ event, ofJob }: { event: FarmEvent; ofJob: boolean }) {
  return (
    <tr>
      <td class="time">{moment(event.wall_ms)}</td>
      <td>
        <Name text={event.what} longest={40} />
      </td>
      {!ofJob && (
        <td>
          {event.job && (
            <Link to={jobAddress(event.job)}>
              <Name text={event.job} longest={40} />
            </Link>
          )}
        </td>
      )}
      <td>{event.task > 0 && <TaskLink task={event.task} />}</td>
      <td class="extra">
        <Name text={event.worker} longest={40} />
      </td>
      <td class="wide">
        <Said text={event.message} />
      </td>
    </tr>
  );
}

function EventsTable({ events, ofJob }: { events: readonly FarmEvent[]; ofJob: boolean }) {
  return (
    <div class="scroller" tabIndex={0} role="region" aria-label="Events">
      <table class="events">
        <thead>
          <tr>
            <th scope="col">Time</th>
            <th scope="col">What</th>
            {!ofJob && <th scope="col">Job</th>}
            <th scope="col">Task</th>
            <th scope="col" class="extra">Worker</th>
            <th scope="col">Message</th>
          </tr>
        </thead>
        <tbody>
          {events.map((event) => (
            <EventRow key={event.event} event={event} ofJob={ofJob} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

interface ListProps {
  events: readonly FarmEvent[];
  ofJob: boolean;
}

function EventsList({ events, ofJob }: ListProps) {
  const [query, setQuery] = useState('');
  const fitting = useMemo(
    () =>
      events.filter((event) =>
        textFits(query, [event.what, event.message, event.job, event.worker, `#${event.task}`]),
      ),
    [events, query],
  );
  const shown = fitting.slice(0, mostShown);
  return (
    <>
      <div class="row filters">
        <Search label="Filter" value={query} onChange={setQuery} />
      </div>
      {shown.length > 0 ? <EventsTable events={shown} ofJob={ofJob} /> : <Empty>No events.</Empty>}
      {fitting.length > shown.length && (
        <p class="faint">
          The newest {mostShown} of {fitting.length}.
        </p>
      )}
    </>
  );
}

export function EventsPage() {
  const { events } = useLive();
  const asked = useAnswer<{ events: FarmEvent[] }>('/events?last=200');
  useEffect(() => {
    if (asked.value) live.addEvents(asked.value.events);
  }, [asked.value]);
  return (
    <>
      <h1>Events</h1>
      {events.length === 0 && <Trouble error={asked.error} />}
      <EventsList events={events} ofJob={false} />
    </>
  );
}

export function JobEvents({ job }: { job: string }) {
  const { events } = useLive();
  const asked = useAnswer<{ events: FarmEvent[] }>(`/jobs/${inAddress(job)}/events?last=200`);
  const ofJob = useMemo(
    () =>
      mergedEvents(
        asked.value?.events ?? [],
        events.filter((event) => event.job === job),
        mostKept,
      ),
    [asked.value, events, job],
  );
  return (
    <>
      {!asked.value && <Trouble error={asked.error} />}
      <EventsList events={ofJob} ofJob />
    </>
  );
}
