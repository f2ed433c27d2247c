// A peer on Fast DDS, which knows nothing of this project: what it sends and receives is made by Fast DDS and Fast CDR.
//
//   peer publish COUNT        sends joint states on /from_peer, once somebody hears them and a line comes on standard input
//   peer receive COUNT        prints the joint states of /to_peer, and before them a line once it hears somebody
//   peer description          prints the text of /robot_description, which it asks for as a latched topic
//
// It joins the domain ROS_DOMAIN_ID as rmw_fastrtps does, in the way that PEER_DISCOVERY says: localhost as with
// ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST, loopback as with ROS_LOCALHOST_ONLY=1, subnet as with neither.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;
using eprosima::fastrtps::Duration_t;
using eprosima::fastrtps::types::ReturnCode_t;

namespace {

const int kDeadline = std::getenv("PEER_DEADLINE") ? std::atoi(std::getenv("PEER_DEADLINE")) : 120;  // s
constexpr size_t kLargestMessage = 1 << 16;

struct JointState {
    static constexpr const char* kType = "sensor_msgs::msg::dds_::JointState_";
    int32_t sec = 0;
    uint32_t nanosec = 0;
    std::string frame_id;
    std::vector<std::string> name;
    std::vector<double> position, velocity, effort;

    template <class Archive>
    void fields(Archive&& each) {
        each(sec), each(nanosec), each(frame_id), each(name), each(position), each(velocity), each(effort);
    }
};

struct Text {
    static constexpr const char* kType = "std_msgs::msg::dds_::String_";
    std::string data;

    template <class Archive>
    void fields(Archive&& each) {
        each(data);
    }
};

template <class Message>
class Support : public fast::TopicDataType {
public:
    Support() {
        setName(Message::kType);
        m_typeSize = kLargestMessage;
        m_isGetKeyDefined = false;
    }

    bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
        FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->max_size);
        Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
        payload->encapsulation = cdr.endianness() == Cdr::BIG_ENDIANNESS ? CDR_BE : CDR_LE;
        cdr.serialize_encapsulation();
        static_cast<Message*>(data)->fields([&](auto& field) { cdr << field; });
        payload->length = static_cast<uint32_t>(cdr.getSerializedDataLength());
        return true;
    }

    bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
        try {
            FastBuffer buffer(reinterpret_cast<char*>(payload->data), payload->length);
            Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
            cdr.read_encapsulation();
            static_cast<Message*>(data)->fields([&](auto& field) { cdr >> field; });
            return true;
        } catch (const eprosima::fastcdr::exception::Exception& error) {
            std::cerr << "damaged message: " << error.what() << std::endl;
            return false;
        }
    }

    std::function<uint32_t()> getSerializedSizeProvider(void*) override {
        return [] { return static_cast<uint32_t>(kLargestMessage); };
    }
    void* createData() override { return new Message; }
    void deleteData(void* data) override { delete static_cast<Message*>(data); }
    bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

/// The parts of rmw_fastrtps' participant that decide on who is found.
fast::DomainParticipant* join() {
    const char* domain = std::getenv("ROS_DOMAIN_ID");
    const char* discovery = std::getenv("PEER_DISCOVERY");
    const std::string how = discovery ? discovery : "localhost";
    auto qos = fast::PARTICIPANT_QOS_DEFAULT;
    qos.name("peer");
    auto& builtin = qos.wire_protocol().builtin;
    if (how == "localhost") {
        rtps::Locator_t unicast, peer;
        builtin.metatrafficMulticastLocatorList.clear();
        builtin.metatrafficUnicastLocatorList.push_back(unicast);
        rtps::IPLocator::setIPv4(peer, "127.0.0.1");
        builtin.initialPeersList.push_back(peer);
    } else if (how == "loopback") {
        auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
        udp->interfaceWhiteList.emplace_back("127.0.0.1");
        qos.transport().use_builtin_transports = false;
        qos.transport().user_transports.push_back(udp);
    } else if (how == "subnet") {
        auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
        udp->TTL = 0;  // Multicast reaches this machine only: there may be a robot in the network.
        qos.transport().use_builtin_transports = false;
        qos.transport().user_transports.push_back(udp);
    } else {
        std::cerr << "PEER_DISCOVERY: " << how << std::endl;
        std::exit(2);
    }
    auto* participant =
        fast::DomainParticipantFactory::get_instance()->create_participant(domain ? std::atoi(domain) : 0, qos);
    if (!participant) {
        std::cerr << "no participant" << std::endl;
        std::exit(2);
    }
    return participant;
}

template <class Message>
fast::Topic* topic(fast::DomainParticipant* participant, const char* name) {
    fast::TypeSupport(new Support<Message>).register_type(participant);
    return participant->create_topic(name, Message::kType, fast::TOPIC_QOS_DEFAULT);
}

template <class Condition>
bool wait_until(Condition condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(kDeadline);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

/// The message that the test makes, too: by integers and halves, which both languages have exactly.
JointState made(int i) {
    JointState message;
    message.sec = 1700000000 + i;
    message.nanosec = 999999999u - static_cast<uint32_t>(i);
    message.frame_id = std::string(static_cast<size_t>(i % 5), 'f');
    for (int joint = 0; joint < 1 + i % 8; ++joint) {
        message.name.push_back("joint_" + std::to_string(joint * i));
        message.position.push_back(0.5 * i - joint);
        if (i % 2) {
            message.effort.push_back(-0.25 * i);
        }
    }
    return message;
}

int publish(int count) {
    auto* participant = join();
    auto qos = fast::DATAWRITER_QOS_DEFAULT;
    qos.reliability().kind = fast::RELIABLE_RELIABILITY_QOS;
    qos.durability().kind = fast::VOLATILE_DURABILITY_QOS;
    qos.history().kind = fast::KEEP_LAST_HISTORY_QOS;
    qos.history().depth = 1000;
    // The last acknowledgement comes in answer to a heartbeat.
    qos.reliable_writer_qos().times.heartbeatPeriod = Duration_t(0.1);
    auto* writer = participant->create_publisher(fast::PUBLISHER_QOS_DEFAULT)
                       ->create_datawriter(topic<JointState>(participant, "rt/from_peer"), qos);
    fast::PublicationMatchedStatus status;
    if (!wait_until([&] { return writer->get_publication_matched_status(status), status.current_count > 0; })) {
        std::cerr << "nobody hears" << std::endl;
        return 1;
    }
    std::string line;
    std::getline(std::cin, line);
    for (int i = 0; i < count; ++i) {
        JointState message = made(i);
        if (!writer->write(&message)) {
            std::cerr << "message " << i << " could not be sent" << std::endl;
            return 1;
        }
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    const bool read = writer->wait_for_acknowledgments(Duration_t(kDeadline, 0)) == ReturnCode_t::RETCODE_OK;
    return read ? 0 : 1;
}

void print(const std::vector<double>& values) {
    for (double value : values) {
        std::printf(" %a", value);
    }
    std::printf(" |");
}

void print(const JointState& message) {
    std::printf("%d %u |%s|", message.sec, message.nanosec, message.frame_id.c_str());
    for (const auto& name : message.name) {
        std::printf(" %s", name.c_str());
    }
    std::printf(" |");
    print(message.position), print(message.velocity), print(message.effort);
    std::printf("\n");
}

void print(const Text& message) {
    std::printf("%s", message.data.c_str());
}

template <class Message>
int receive(int count, const char* name, bool latched) {
    auto* participant = join();
    auto qos = fast::DATAREADER_QOS_DEFAULT;
    qos.reliability().kind = fast::RELIABLE_RELIABILITY_QOS;
    qos.durability().kind = latched ? fast::TRANSIENT_LOCAL_DURABILITY_QOS : fast::VOLATILE_DURABILITY_QOS;
    qos.history().kind = fast::KEEP_LAST_HISTORY_QOS;
    qos.history().depth = 1000;
    auto* reader = participant->create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT)
                       ->create_datareader(topic<Message>(participant, name), qos);
    fast::SubscriptionMatchedStatus status;
    if (!wait_until([&] { return reader->get_subscription_matched_status(status), status.current_count > 0; })) {
        std::cerr << "nobody publishes" << std::endl;
        return 1;
    }
    if (!latched) {
        std::printf("ready\n");
        std::fflush(stdout);
    }
    int received = 0;
    const bool all = wait_until([&] {
        Message message;
        fast::SampleInfo info;
        while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK) {
            if (info.valid_data) {
                print(message);
                ++received;
            }
        }
        return received >= count;
    });
    std::fflush(stdout);
    // For the last acknowledgement to go out.
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    return all ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "publish" && argc == 3) {
        return publish(std::atoi(argv[2]));
    }
    if (what == "receive" && argc == 3) {
        return receive<JointState>(std::atoi(argv[2]), "rt/to_peer", false);
    }
    if (what == "description") {
        return receive<Text>(1, "rt/robot_description", true);
    }
    std::cerr << "usage: peer publish COUNT | receive COUNT | description" << std::endl;
    return 2;
}
