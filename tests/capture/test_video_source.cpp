#include "core/capture/frame_source.h"
#include "tests/support/temporary_folder.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace farol::capture {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

cv::Mat picture(int brightness) {
    return cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(brightness));
}

std::string writeVideo(const test::TemporaryFolder& folder, int frames) {
    std::string path = (folder / "walk.avi").string();
    cv::VideoWriter writer(path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 10.0, cv::Size(64, 48));
    for (int i = 0; i < frames; ++i) writer.write(picture(20 * i));
    return path;
}

/// Serves MJPEG on the loopback: `frames` pictures to each client, `clients` times, then nobody answers.
class PictureServer {
public:
    PictureServer(int clients, int frames) {
        m_socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        ::bind(m_socket, reinterpret_cast<sockaddr*>(&address), sizeof address);
        ::listen(m_socket, 4);
        socklen_t length = sizeof address;
        ::getsockname(m_socket, reinterpret_cast<sockaddr*>(&address), &length);
        m_port = ntohs(address.sin_port);
        m_thread = std::thread([this, clients, frames] { serve(clients, frames); });
    }
    ~PictureServer() {
        ::shutdown(m_socket, SHUT_RDWR);
        m_thread.join();
        ::close(m_socket);
    }
    PictureServer(const PictureServer&) = delete;
    PictureServer& operator=(const PictureServer&) = delete;

    std::string address() const { return "http://127.0.0.1:" + std::to_string(m_port) + "/camera.mjpg"; }

private:
    void serve(int clients, int frames) const {
        for (int client = 0; client < clients; ++client) {
            int connection = ::accept(m_socket, nullptr, nullptr);
            if (connection < 0) return;
            char request[2048];
            (void)::recv(connection, request, sizeof request, 0);
            send(connection,
                 "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=frame\r\n\r\n");
            for (int i = 0; i < frames; ++i) {
                std::vector<unsigned char> jpeg;
                cv::imencode(".jpg", picture(30 * (i % 8)), jpeg);
                send(connection,
                     "--frame\r\nContent-Type: image/jpeg\r\nContent-Length: " + std::to_string(jpeg.size()) +
                         "\r\n\r\n" + std::string(jpeg.begin(), jpeg.end()) + "\r\n");
            }
            ::close(connection);
        }
        // The listening socket stays unanswered from here: shut it so that later clients are refused at once.
        ::shutdown(m_socket, SHUT_RDWR);
    }
    static void send(int connection, const std::string& bytes) {
        (void)::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    }

    int m_socket = -1;
    int m_port = 0;
    std::thread m_thread;
};

TEST(VideoSource, AVideoFileGivesItsFramesAndTimes) {
    test::TemporaryFolder folder;
    auto source = openSource(writeVideo(folder, 5));
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_FALSE((*source)->live());
    EXPECT_NEAR((*source)->framePeriod(), 0.1, 1e-6);
    std::vector<double> times;
    cv::Mat first;
    while (auto frame = (*source)->next()) {
        if (frame->index == 0) first = frame->image;
        times.push_back(frame->capturedAt);
        EXPECT_EQ(frame->index + 1, times.size());
        EXPECT_EQ(frame->size(), (ImageSize{64, 48}));
    }
    ASSERT_EQ(times.size(), 5U);
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], 0.1 * static_cast<double>(i), 1e-6);
    EXPECT_LT(first.at<cv::Vec3b>(20, 20)[0], 12)
        << "later frames must not be written into a picture handed out";
    EXPECT_FALSE((*source)->next()) << "the end stays the end";
}

TEST(VideoSource, AnotherRateGivesOtherTimes) {
    test::TemporaryFolder folder;
    SourceOptions options;
    options.framesPerSecond = 2.0;
    auto source = openSource(writeVideo(folder, 3), options);
    ASSERT_TRUE(source);
    std::vector<double> times;
    while (auto frame = (*source)->next()) times.push_back(frame->capturedAt);
    EXPECT_THAT(times, ElementsAre(0.0, 0.5, 1.0));
}

TEST(VideoSource, AFileThatIsNoVideoIsNamed) {
    test::TemporaryFolder folder;
    folder.write("lie.mp4", "not a video at all");
    folder.write("empty.avi", "");
    for (const char* name : {"lie.mp4", "empty.avi"}) {
        auto source = openSource((folder / name).string());
        ASSERT_FALSE(source) << name;
        EXPECT_EQ(source.error().code, ErrorCode::UnsupportedFormat);
        EXPECT_THAT(source.error().text(), HasSubstr(name));
    }
}

TEST(VideoSource, ALostStreamIsToldAndTriedAgain) {
    PictureServer server(2, 6);
    SourceOptions options;
    options.reconnectDelayMs = 1;
    options.reconnectAttempts = 2;
    auto source = openSource(server.address(), options);
    ASSERT_TRUE(source) << source.error().text();
    EXPECT_TRUE((*source)->live());
    std::vector<SourceEventKind> events;
    (*source)->onEvent([&](const SourceEvent& event) { events.push_back(event.kind); });
    std::uint64_t frames = 0;
    double last = -1.0;
    while (auto frame = (*source)->next()) {
        EXPECT_EQ(frame->index, frames++);
        EXPECT_GE(frame->capturedAt, last);
        last = frame->capturedAt;
    }
    EXPECT_GE(frames, 8U) << "pictures of both connections";
    using enum SourceEventKind;
    EXPECT_THAT(events, ElementsAre(ConnectionLost, Reconnecting, Reconnected, ConnectionLost, Reconnecting,
                                    Reconnecting));
}

TEST(VideoSource, AStopEndsTheLongestPause) {
    PictureServer server(1, 3);
    SourceOptions options;
    options.reconnectDelayMs = 3'600'000;
    auto source = openSource(server.address(), options);
    ASSERT_TRUE(source);
    (*source)->onEvent([&](const SourceEvent& event) {
        if (event.kind == SourceEventKind::ConnectionLost) (*source)->requestStop();
    });
    while ((*source)->next()) {
    }
    EXPECT_TRUE((*source)->stopRequested());
}

TEST(VideoSource, AnAddressThatDoesNotAnswerIsNamedWithoutItsPassword) {
    auto source = openSource("http://guest:secret@127.0.0.1:1/video");
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().code, ErrorCode::Unavailable);
    EXPECT_THAT(source.error().text(), HasSubstr("127.0.0.1:1/video"));
    EXPECT_THAT(source.error().text(), testing::Not(HasSubstr("secret")));
}

} // namespace
} // namespace farol::capture
