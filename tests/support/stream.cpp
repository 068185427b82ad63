#include "tests/support/stream.hpp"

namespace fagorc::test {

Stream::Stream() {
    for (Axis a : {Axis::X, Axis::Y, Axis::Z, Axis::C}) {
        machine.axes[a].exists = true;
        machine.axes[a].min = -500;
        machine.axes[a].max = 500;
    }
    programs.list = {{"folder/part.pit", "%PART,MX,\nG1 X10 Z-5 F200\nM30\n"}};
    next.at.line = 0;
    next.at.feed = 200;
    next.at.speed = 1000;
    state();
    frame({});
    chain({diag::FileId{0}, {}, 0});
}

void Stream::add(const operation::What& what) {
    ++next.at.line;
    next.what = what;
    operations.push_back(next);
}

void Stream::message(std::string text) {
    texts.push_back(std::move(text));
    operation::Event e;
    e.kind = operation::Event::Kind::message;
    e.text = static_cast<std::uint32_t>(texts.size() - 1);
    add(e);
}

void Stream::play(operation::Sink& sink) const {
    for (const operation::Operation& o : operations) sink.push(o);
    sink.finish();
}

Stream everything() {
    using Kind = operation::Event::Kind;
    Stream s;
    s.programs.list.push_back({"000012.PIT", std::string(100000, 'N')});
    s.event(Kind::tool, 1);
    s.now.tool = s.now.offset = 1;
    s.now.length_x = 2;
    s.now.length_z = 30;
    s.now.nose = 0.4;
    s.state();
    s.event(Kind::offset, 1);
    s.rapid(1, 20);
    s.now.modal.motion = program::Motion::line;
    s.now.modal.feed = program::FeedMode::per_revolution;
    s.state();
    s.next.at.feed = 0.25;
    s.line(-10, 20);
    s.arc({-20, 30}, {-20, 20}, false);
    s.chain({diag::FileId{1}, s.next.at.chain, 7});
    s.next.at.pass = 3;
    s.arc({-20, 30}, {-25, 30}, true, true);
    s.message("a \"quoted\", text; \xe9");
    s.add(operation::Thread{{-40, 30}, 1.5, 90});
    s.add(operation::Dwell{0.75});
    s.add(operation::Barrier{operation::Barrier::Why::live});
    s.next.others[Axis::C] = 90;
    s.next.moved.add(Axis::C);
    s.line(-40, 32);
    s.next.moved = {};
    s.now.modal.plane_code = program::PlaneCode::xy;
    s.now.modal.plane = plane_g17;
    s.frame({{{0, 0, 100, 0, 0, 0, 0, 0, 0}}, false});
    s.state();
    s.arc({42, 10}, {32, 10}, true);
    operation::Event home;
    home.kind = Kind::home;
    home.axes.add(Axis::X);
    s.next.others[Axis::X] = 250;
    s.add(home);
    s.next.at.speed = 2000;
    s.rapid(60, 0);
    s.event(Kind::program_end);
    return s;
}

}  // namespace fagorc::test
